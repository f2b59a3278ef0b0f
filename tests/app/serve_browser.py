# The page of `etalon serve` in Chromium. Called with the program and the browser, in a folder with
# ball.p3f.
import sys

from served import Browser, Relay, Served, until

PROGRAM, CHROMIUM = sys.argv[1:3]

with Served(PROGRAM, "ball.p3f", "-q", "--spp", "16777216", "-o", "a.exr") as served, \
        Browser(CHROMIUM, "profile") as browser:
    relay = Relay(served.port)
    browser.call("Page.navigate", url=served.url.replace(str(served.port), str(relay.port)))

    def text(name):
        return browser.value("document.getElementById('%s').textContent" % name)

    # The image arrives, and the figures go on.
    until(lambda: browser.value("document.getElementById('picture')?.naturalWidth") == 32)
    assert browser.value("document.getElementById('picture').naturalHeight") == 24
    until(lambda: browser.value("document.querySelectorAll('#chart circle').length") > 1)
    assert text("scene") == "ball.p3f" and text("stage") == "Rendering."
    assert float(text("samples")) > 1 and float(text("error")) > 0

    # It shows another image as it converges, and what is asked for.
    source = "document.getElementById('picture').src"
    for name in ("image", "samples", "seconds"):
        before = browser.value(source)
        browser.value("document.querySelector('[data-name=%s]').click()" % name)
        until(lambda: browser.value(source) != before)
        assert browser.value("document.getElementById('legend').hidden") == (name == "image")
        assert browser.value("document.querySelector('[aria-selected=true]').dataset.name") == name

    # It fits a phone and a desk's screen, light and dark.
    for width in (390, 1280):
        browser.call("Emulation.setDeviceMetricsOverride", width=width, height=800, deviceScaleFactor=1, mobile=False)
        assert browser.value("document.documentElement.scrollWidth") <= width
    for scheme, paper in (("light", "rgb(255, 255, 255)"), ("dark", "rgb(18, 22, 27)")):
        browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        assert browser.value("getComputedStyle(document.body).backgroundColor") == paper

    # A connection that fails for a while is no end.
    assert browser.complaints == [], browser.complaints
    relay.is_cut = True
    until(lambda: text("stage") == "No answer: the program has ended, or the connection is lost.")
    assert browser.value("document.getElementById('stop').disabled")
    relay.is_cut = False
    until(lambda: text("stage") == "Rendering.")
    assert not browser.value("document.getElementById('stop').disabled")
    browser.complaints = []  # of requests without an answer

    # The button ends the rendering as ^C does; the page has the last of it.
    browser.value("document.getElementById('stop').click()")
    until(lambda: text("stage") == "Done: the image is written.")
    assert browser.value("document.getElementById('stop').disabled")
    assert served.end() == 130
    assert browser.complaints == [], browser.complaints
