"""The page in a browser."""

import re
import shutil
import subprocess

import pytest

BROWSER = shutil.which("chromium")
FLAGS = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--enable-logging=stderr",
    "--window-size=1366,768",
]
PROBE = """<script>
window.onload = () => {
  const drawn = [...document.images].map(i => i.complete && i.naturalWidth > 100 && i.width > 100);
  const box = document.getElementById("verdict").getBoundingClientRect();
  document.body.dataset.drawn = drawn.join(" ");
  document.body.dataset.bottom = box.bottom;
  document.body.dataset.wide = document.documentElement.scrollWidth <= window.innerWidth;
};
</script>"""

pytestmark = pytest.mark.skipif(BROWSER is None, reason="the browser chromium is not installed")


@pytest.mark.parametrize("verdict", ["named", "cannot_tell"])
def test_page_opens_with_its_plots_and_the_verdict_in_view(report, tmp_path, verdict):
    page = (report(verdict) / "report.html").read_text("utf-8")
    probed = tmp_path / "probed.html"
    probed.write_text(page.replace("</body>", f"{PROBE}</body>"), "utf-8")
    profile = f"--user-data-dir={tmp_path / 'profile'}"
    done = subprocess.run(
        [BROWSER, *FLAGS, profile, "--dump-dom", probed.as_uri()],
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    assert "CONSOLE" not in done.stderr, done.stderr
    said = dict(re.findall(r'data-(drawn|bottom|wide)="([^"]*)"', done.stdout))
    assert said["drawn"].split() == ["true"] * page.count("<img")
    assert float(said["bottom"]) < 768 and said["wide"] == "true"
