"""``python -m tests.support.pictures``: the pictures of reports in README and manual, from pages in Chromium.

The diagnosis's is `diagnosis.svg`, which ``deltacal demo`` draws.

They lie beside the examples that they show. Needs Chromium and its driver (Debian: chromium, chromium-driver).
"""

from __future__ import annotations

import base64
import shutil
import sys
import tempfile
from pathlib import Path

import deltacal_gen as dc

EXAMPLES = Path(dc.__file__).parent / "examples"
WIDTH, HEIGHT = 900, 640


def main() -> int:
    """Make the pages and the pictures; return 0."""
    from selenium import webdriver

    options = webdriver.ChromeOptions()
    for flag in ("--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"):
        options.add_argument(flag)
    driver = webdriver.Chrome(options=options, service=webdriver.ChromeService(shutil.which("chromedriver")))
    try:
        with tempfile.TemporaryDirectory() as folder:
            pages = Path(folder)
            dc.derivation("delta/42", output=pages / "derivation.html")
            diamond = EXAMPLES / "diamond"
            dc.identify(
                diamond / "robot.toml", diamond / "recording.csv", model="diamond/10", report=pages / "calibration.html"
            )
            delta, gearbox = EXAMPLES / "delta", EXAMPLES / "gearbox"
            dc.study(
                delta / "robot.toml",
                plan=delta / "poses.csv",
                model="delta/32",
                noise=0.01,
                suspect=[gearbox / "truth.toml"],
                trials=300,
                diagnoses=1,
                report=pages / "study.html",
            )
            for name in ("diamond", "gearbox", "planar_parallelogram", "serial"):
                shutil.copytree(EXAMPLES / name, pages / "shop" / name)
            dc.batch(pages / "shop", output=pages / "run")
            for page, at, height, picture in (
                ("derivation.html", "body", 1060, delta / "derivation.png"),
                ("derivation.html", "#step-5", HEIGHT, delta / "derivation_steps.png"),
                ("calibration.html", "body", HEIGHT, diamond / "calibration.png"),
                ("study.html", "body", HEIGHT, delta / "study.png"),
                ("run/index.html", "body", HEIGHT, gearbox / "batch.png"),
            ):
                driver.get((pages / page).as_uri())
                size = {"width": WIDTH, "height": height, "deviceScaleFactor": 1, "mobile": False}
                driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
                driver.execute_script(f"document.querySelector('{at}').scrollIntoView()")
                picture.write_bytes(base64.b64decode(driver.get_screenshot_as_base64()))
                print(picture.relative_to(EXAMPLES.parent.parent.parent))
    finally:
        driver.quit()
    return 0


if __name__ == "__main__":
    sys.exit(main())
