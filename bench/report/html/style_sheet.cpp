#include <fmt/format.h>

#include "bench/report/html/html.h"

namespace etalon::bench_report {
namespace {

namespace rules {

/// The colours of tracers are those of Okabe & Ito, darker on white and lighter on black, since
/// they are also used for text. The page is light, or dark if the screen prefers it; prints are
/// always light.
constexpr std::string_view palette = R"(
:root{color-scheme:light dark;
--paper:#fff;--card:#f6f7f9;--ink:#1c232b;--quiet:#57626d;--rule:#dfe3e8;--edge:#aebac7;
--link:#005a9c;--good:#00684b;--bad:#b3400f;--warn:#fff3dc;
--colour-1:#0072b2;--colour-2:#d55e00;--colour-3:#007d5b;--colour-4:#b5588f;--colour-5:#b27700;
--colour-6:#3d93c8;--colour-7:#68727d}
@media screen and (prefers-color-scheme:dark){:root{
--paper:#12161b;--card:#1a2027;--ink:#e4e8ec;--quiet:#9aa6b2;--rule:#2c343d;--edge:#566472;
--link:#7cc0f4;--good:#4ecfa3;--bad:#ff9a62;--warn:#3a2d12;
--colour-1:#4aa3e0;--colour-2:#f08040;--colour-3:#2fc08f;--colour-4:#dd8fbb;--colour-5:#e8ac2e;
--colour-6:#8fd0f5;--colour-7:#98a4b0}}
)";

/// Text of the page, from its width to its headings.
constexpr std::string_view text = R"(
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%;text-size-adjust:100%;scroll-behavior:smooth}
body{margin:0;background:var(--paper);color:var(--ink);
font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,Helvetica,Arial,"DejaVu Sans",sans-serif;
font-variant-numeric:tabular-nums;overflow-wrap:break-word}
header,main,footer{max-width:76rem;margin:0 auto;padding:0 1.25rem}
header{padding-top:2.5rem}
h1{font-size:2.1rem;line-height:1.15;letter-spacing:-.015em;margin:0 0 .4rem}
h2{font-size:1.4rem;line-height:1.25;letter-spacing:-.01em;margin:0 0 .6rem}
h3{font-size:1.05rem;line-height:1.3;margin:0 0 .7rem;font-weight:600}
h4{font-size:.92rem;margin:0 0 .3rem;font-weight:600}
p{margin:0 0 .8rem;max-width:70ch}
a{color:var(--link)}
small,.quiet,figcaption,time{color:var(--quiet)}
section{margin-top:3rem;padding-top:1.6rem;border-top:1px solid var(--rule)}
)";

/// Warnings about the report, its key figures and its contents.
constexpr std::string_view first_screen = R"(
.missing{background:var(--warn);border-left:4px solid var(--colour-5);padding:.5rem .8rem;
max-width:none}
.facts{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,10rem),1fr));gap:.7rem;
margin:1.4rem 0}
.fact{min-width:0;background:var(--card);border:1px solid var(--rule);border-radius:.5rem;padding:.9rem 1rem}
.fact b{display:block;font-size:2rem;line-height:1.1;letter-spacing:-.02em}
.fact span{display:block;font-weight:600;margin:.25rem 0 .1rem;line-height:1.3}
.fact small{display:block;line-height:1.35;font-size:.82rem}
nav ul{display:flex;flex-wrap:wrap;gap:.2rem 1.2rem;list-style:none;margin:0;padding:0}
nav a{display:inline-block;padding:.25rem 0}
)";

/// Figures and their captions.
constexpr std::string_view figures = R"(
figure{margin:1.8rem 0 2.4rem}
figure.folded{margin:0 0 .4rem}
figure.folded details[open]{margin-bottom:1.6rem}
figcaption{font-size:.88rem;margin-top:.6rem}
figcaption p{margin:0 0 .2rem;max-width:none}
.source{font-size:.78rem}
.source span{display:inline-block;max-width:100%}
code{font:.95em/1.4 ui-monospace,SFMono-Regular,Consolas,"DejaVu Sans Mono",monospace;
overflow-wrap:anywhere}
time{white-space:nowrap;margin-right:.6em}
)";

/// Tables, which scroll horizontally if they are wider than the page.
constexpr std::string_view tables = R"(
.scroll{overflow-x:auto;border:1px solid var(--rule);border-radius:.4rem}
table{border-collapse:collapse;font-size:.86rem;line-height:1.4}
.scroll table{width:100%}
th,td{padding:.3rem .65rem;text-align:left;vertical-align:top}
thead th{font-weight:600;color:var(--quiet);vertical-align:bottom;border-bottom:1px solid var(--rule)}
tbody th{font-weight:500}
.scroll tbody tr:nth-child(even)>*{background:var(--card)}
.scroll tbody th{position:sticky;left:0;background:var(--paper)}
.number{text-align:right}
.number,.name{white-space:nowrap}
td:not(.number):not(.name){min-width:8rem}
.good{color:var(--good)}
.bad{color:var(--bad);font-weight:600}
.good::before{content:"✓ "}
.bad::before{content:"✗ "}
summary{cursor:pointer;padding:.35rem 0;font-weight:600}
)";

/// Bars as rows of a table; in a narrow group their numbers are above and below them.
constexpr std::string_view bars = R"(
.groups{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,32rem),1fr));
gap:1.4rem 2.4rem}
.group{container-type:inline-size;min-width:0}
.bars{width:100%;table-layout:fixed}
.bars th,.bars td{min-width:0;padding:.18rem 0;vertical-align:middle;white-space:nowrap}
.bars .name{width:9.8rem}
.bars .value{width:3.7rem;text-align:right}
.bars .ratio{width:6.6rem;text-align:right}
.bars .note{width:7.4rem;text-align:right;white-space:pre-line}
.bars tbody .value{font-weight:600}
.bars tbody .ratio,.bars tbody .note,.bars thead th+td~th{font-size:.78rem}
.bars tbody .ratio,.bars .note:not(.good):not(.bad){color:var(--quiet)}
.bars thead th{border:none;vertical-align:bottom}
.bars thead .name{color:var(--ink);font-size:.92rem}
.rod{display:block;width:100%;height:.85rem}
.swatch{width:.75rem;height:.75rem;margin-right:.4rem;vertical-align:-.05rem}
.b1{fill:var(--colour-1)}.b2{fill:var(--colour-2)}.b3{fill:var(--colour-3)}
.b4{fill:var(--colour-4)}.b5{fill:var(--colour-5)}.b6{fill:var(--colour-6)}
.b7{fill:var(--colour-7)}
.spread{fill:var(--ink)}
@container (max-width:29rem){
.bars tr{display:grid;grid-template-columns:1fr auto;padding:.2rem 0}
.bars th,.bars td,.bars .name,.bars .value,.bars .ratio,.bars .note{padding:0;width:auto}
.bars .length{grid-column:1/3;grid-row:2;padding:.1rem 0 .15rem}
.bars .ratio{text-align:left}
.bars thead .length,.bars thead .ratio,.bars thead .note{display:none}
.bars tbody .note:not(:empty)::after{content:" " attr(data-name);font-weight:400}}
)";

/// Plots and images.
constexpr std::string_view plots = R"(
.key{display:flex;flex-wrap:wrap;gap:.2rem 1.4rem;list-style:none;margin:0 0 .8rem;padding:0;
font-size:.86rem}
.charts{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,20.5rem),1fr));
gap:1.6rem 2rem}
.plot{min-width:0}
.remark{font-size:.82rem;margin:.2rem 0 0;color:var(--quiet);max-width:30rem}
.chart{display:block;width:100%;height:auto;max-width:30rem}
.images{display:flex;flex-wrap:wrap;gap:1rem}
.image{flex:1 1 16rem;max-width:24rem}
.image p{margin:.2rem 0 0;font-size:.82rem;color:var(--quiet)}
img{display:block;width:100%;height:auto;border-radius:.3rem}
)";

/// The footer, and the rules for small screens.
constexpr std::string_view phone = R"(
footer{margin-top:3rem;padding-top:1rem;padding-bottom:3rem;border-top:1px solid var(--rule);
font-size:.85rem;color:var(--quiet)}
@media (max-width:30rem){th,td{padding-left:.4rem;padding-right:.4rem}h1{font-size:1.7rem}header{padding-top:1.5rem}
header,main,footer{padding-left:1rem;padding-right:1rem}section{margin-top:2rem}}
)";

/// The page as it is printed.
constexpr std::string_view paper = R"(
@media print{
@page{margin:14mm}
body{font-size:9.5pt}
header,main,footer{max-width:none;padding-left:0;padding-right:0}
nav{display:none}
.group,.plot,.image,.fact,tr,figcaption{break-inside:avoid}
h2,h3,h4,summary{break-after:avoid}
.scroll{overflow:visible;border:none}
.scroll table{font-size:7pt}
.scroll th,.scroll td{padding:.1rem .3rem}
details::details-content{content-visibility:visible;block-size:auto;opacity:1}
*{print-color-adjust:exact;-webkit-print-color-adjust:exact}}
)";

}  // namespace rules

}  // namespace

std::string style_sheet() {
    using namespace rules;
    return fmt::format(
        "{}",
        fmt::join({palette, text, first_screen, figures, tables, bars, plots, phone, paper}, ""));
}

}  // namespace etalon::bench_report
