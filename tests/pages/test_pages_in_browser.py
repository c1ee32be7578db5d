"""Every kind of page in headless Chromium: no error, no request, no empty formula, nothing wider than the screen."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import deltacal_gen as dc
from deltacal_gen.pages import report
from deltacal_gen.pages.certificate import certificate
from derive.review import rendering, reports
from derive.review.subjects import subject

ROOT = Path(__file__).resolve().parents[2]
DRIVER, BROWSER = shutil.which("chromedriver"), shutil.which("chromium") or shutil.which("chromium-browser")
WIDTHS = (1280, 400)
OVERFLOWING = """
const wide = [];
for (const e of document.querySelectorAll('body *')) {
  if (e.closest('.math, .wide, pre, svg, math')) continue;  // these scroll, or scale
  if (e.getBoundingClientRect().right > window.innerWidth + 1) wide.push(e.outerHTML.slice(0, 90));
}
return [document.documentElement.scrollWidth - window.innerWidth, wide];
"""
APART = """
return [...document.querySelectorAll(':not(pre) > code')].filter(e => getComputedStyle(e).display !== 'inline').map(
  e => e.outerHTML);
"""
PAPER = 672  # px of CSS: A4 within the margins of the stylesheet
BEYOND_PAPER = """
return [...document.querySelectorAll('body *')].filter(e => !e.closest('svg, .said:not([open])')  // these stay folded
  && e.getBoundingClientRect().right > window.innerWidth + 1).map(e => e.outerHTML.slice(0, 90));
"""
EMPTY = """
return [...document.querySelectorAll('math')].filter(e => !e.closest('details:not([open])')).map(
  e => e.getBoundingClientRect()).filter(r => !(r.width > 2 && r.height > 5)).length;
"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    webdriver = pytest.importorskip("selenium.webdriver", reason="Selenium is not installed")
    if DRIVER is None or BROWSER is None:
        pytest.skip("Chromium and its driver are not installed (Debian: chromium, chromium-driver)")
    options = webdriver.ChromeOptions()
    options.binary_location = BROWSER
    profile = tmp_path_factory.mktemp("profile")
    for flag in ("--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(options=options, service=webdriver.ChromeService(DRIVER))
    yield driver
    driver.quit()


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """One page of each kind."""
    folder = tmp_path_factory.mktemp("pages")
    example = ROOT / "src/deltacal_gen/examples/diamond"
    found = dc.identify(example / "robot.toml", example / "recording.csv", model="diamond/10")
    texts = {"calibration": report.calibration(found)}
    again = dc.read_recording(example / "recording.csv", dc.load_mechanism("diamond"))
    texts["certificate"] = certificate(dc.certificate(found, again))
    diagnosis = dc.diagnose(example / "robot.toml", example / "recording.csv")
    texts["diagnosis"] = report.diagnosis(diagnosis)
    chosen = [subject(name) for name in ("planar_parallelogram/9", "thermal_growth")]
    made = list(reports.made(chosen, lambda text: None))
    for one, template, content in made:
        ((_, texts[template]),) = reports.files(folder / f"{one.stem}.html", template, content).items()
    index = reports.index([(one, content) for one, _, content in made], ".html")
    texts["contents"] = rendering.page("contents", title="Derivations", **index)
    for name, text in texts.items():
        (folder / f"{name}.html").write_text(text, encoding="utf-8")
    return {name: folder / f"{name}.html" for name in texts}


@pytest.mark.parametrize("kind", ["calibration", "certificate", "diagnosis", "derivation", "effect", "contents"])
def test_pages_are_readable(kind: str, browser: Any, pages: dict[str, Path]) -> None:
    for width in WIDTHS:
        metrics = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False}
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
        browser.get("about:blank")
        browser.get_log("performance")  # the browser's own first page
        browser.get(pages[kind].as_uri())
        assert [e for e in browser.get_log("browser") if e["level"] in ("SEVERE", "WARNING")] == []
        sent = [json.loads(e["message"])["message"] for e in browser.get_log("performance")]
        asked = [m["params"]["request"]["url"] for m in sent if m["method"] == "Network.requestWillBeSent"]
        assert [url for url in asked if not url.startswith(("file:", "data:"))] == []
        assert len([url for url in asked if url.startswith("file:")]) <= 1
        beyond, wide = browser.execute_script(OVERFLOWING)
        assert beyond <= 0, (kind, width, wide)
        assert wide == [], (kind, width)
        assert browser.execute_script(EMPTY) == 0
        if kind in ("derivation", "effect"):
            assert browser.execute_script("return document.querySelectorAll('math').length") > 5


@pytest.mark.parametrize("kind", ["calibration", "certificate", "diagnosis", "derivation", "effect", "contents"])
def test_pages_fit_on_paper(kind: str, browser: Any, pages: dict[str, Path]) -> None:
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    metrics = {"width": PAPER, "height": 900, "deviceScaleFactor": 1, "mobile": False}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
    try:
        browser.get(pages[kind].as_uri())
        assert browser.execute_script(BEYOND_PAPER) == []
    finally:
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
