// The report in Chromium, if it is installed.
#include "bench/report/html/html.h"
#include "bench/report/sections/sections.h"
#include "tests/app/run_program.h"
#include "tests/bench/report_results.h"
#include "tests/catch.h"

using namespace etalon::test;

namespace {

/// Returns the path of a working browser; empty if there is none.
std::string chromium(const Folder& folder) {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
        const std::string version = std::string(name) + " --version";
        if (folder.shell(version).status == 0) return name;
    }
    return {};
}

/// Renders the page at the widths of a phone and a desktop screen, and reports for each the width
/// of its content, clipped chart texts and the background behind texts.
const std::string probe = R"(<!DOCTYPE html><body>
<iframe width="390" height="800" style="border:0" src="index.html"></iframe>
<iframe width="1280" height="800" style="border:0" src="index.html"></iframe>
<script>
function is_cut(text) {
  const b = text.getBBox(), v = text.ownerSVGElement.viewBox.baseVal;
  return b.x < 0 || b.y < 0 || b.x + b.width > v.width || b.y + b.height > v.height;
}
onload = () => {
  const said = [...document.querySelectorAll('iframe')].map(frame => {
    const page = frame.contentDocument, texts = [...page.querySelectorAll('svg.chart text')];
    const root = page.documentElement;
    return `at ${frame.width} too wide by ${root.scrollWidth - root.clientWidth}, ` +
      `texts ${texts.length > 9}, cut ${texts.filter(is_cut).length}, ` +
      `paper ${frame.contentWindow.getComputedStyle(page.body).backgroundColor}`;
  });
  document.body.textContent = said.join('; ');
};
</script>)";

std::string shown(const Folder& folder, const std::string& browser, const std::string& options) {
    const auto r = folder.shell(
        browser +
        " --headless=new --no-sandbox --disable-gpu --disable-dev-shm-usage "
        "--allow-file-access-from-files --enable-logging=stderr --virtual-time-budget=3000 "
        "--user-data-dir=profile --dump-dom " +
        options + " \"file://$PWD/probe.html\"");
    CHECK_THAT(r.err, !ContainsSubstring("CONSOLE"));
    return r.out;
}

}  // namespace

TEST_CASE("Chromium shows a report without errors, from the width of a phone, light and dark",
          "[needs_chromium]") {
    const Folder f;
    const std::string browser = chromium(f);
    SKIP_UNLESS(!browser.empty(), "no Chromium that runs");
    f.write("index.html",
            etalon::bench_report::html(etalon::bench_report::page_of(sample_results())));
    f.write("probe.html", probe);
    const std::string light = "paper rgb(255, 255, 255)", dark = "paper rgb(18, 22, 27)";
    for (const auto& [options, paper] :
         {std::pair{"--blink-settings=preferredColorScheme=1", light},
          std::pair{"--blink-settings=preferredColorScheme=0", dark}}) {
        const std::string said = shown(f, browser, options);
        CHECK_THAT(said, ContainsSubstring("at 390 too wide by 0, texts true, cut 0, " + paper));
        CHECK_THAT(said, ContainsSubstring("at 1280 too wide by 0, texts true, cut 0, " + paper));
    }
}
