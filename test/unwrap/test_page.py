"""The page of --html in a real browser: it shows what the report says, without a message on the console.

Screenshots go to the folder that the third argument names, if there is one."""

import json
import math
import os
import sys
import tempfile
from pathlib import Path

from browser import Browser, find_browser
from support import Case, main, read_obj, sphere, to_off, to_text_stl, torus

SCREENSHOTS = Path(sys.argv.pop(3)) if len(sys.argv) > 3 else None
SIZES = {"desktop": (1400, 900, False), "phone": (390, 844, True)}  # the phone in the dark


def parts(number):
    """Spheres on a square grid."""
    points, faces = [], []
    for i in range(number):
        more, triangles = sphere(1 + i % 2)
        faces += [tuple(v + len(points) for v in face) for face in triangles]
        points += [(x + 2.4 * (i % 4), y + 2.8 * (i // 4), z) for x, y, z in more]
    return points, faces


def ring(n):
    """A torus that looks like one."""
    points, faces = torus(n)
    turn = 2 * math.pi / n
    place = lambda i, j: ((3 + math.cos(turn * j)) * math.cos(turn * i), (3 + math.cos(turn * j)) * math.sin(turn * i),
                          math.sin(turn * j))
    return [place(i, j) for i, j, _ in points], faces


def cow():
    path = Path(os.environ.get("CGAL_DATA_DIR", "")) / "meshes" / "cow.off"
    return path.read_text() if path.exists() else to_off(sphere(4))


class Page(Case):
    @classmethod
    def setUpClass(cls):
        if find_browser() is None:
            print("no browser: skipped")
            sys.exit(77)

    def setUp(self):
        super().setUp()
        self.browser = self.start_browser()

    def start_browser(self, more_flags=()):
        profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(profile.cleanup)
        browser = Browser(profile.name, more_flags=more_flags)
        self.addCleanup(browser.close)
        return browser

    def count_colors(self, canvas):
        """Pixels of a canvas by color."""
        return self.browser.evaluate(f"""(() => {{
            const canvas = document.createElement('canvas'), source = document.getElementById('{canvas}');
            canvas.width = source.width; canvas.height = source.height;
            const context = canvas.getContext('2d');
            context.drawImage(source, 0, 0);
            const data = context.getImageData(0, 0, canvas.width, canvas.height).data;
            let covered = 0, pink = 0;
            for(let i = 0; i < data.length; i += 4) {{
              covered += data[i + 3] > 128;
              pink += data[i] > 200 && data[i + 1] < 120 && data[i + 2] > 100 && data[i + 3] > 128;
            }}
            return {{covered: covered / (data.length / 4), pink}};
          }})()""")

    def check_values(self, report):
        shown = self.browser.evaluate("Array.from(document.querySelectorAll('[data-key]'),"
                                      " e => [e.dataset.key, e.dataset.value])")
        self.assertGreater(len(shown), 15)
        for key, value in shown:
            outer, _, inner = key.partition(".")
            if inner:
                self.assertEqual(json.loads(value), report[outer][inner], key)
            elif key in ("tradeoff", "charts_distortion"):
                self.assertIn(json.loads(value), report[key])
            else:
                self.assertEqual(json.loads(value), report[key], key)
        embedded = self.browser.evaluate("document.getElementById('report').textContent")
        self.assertEqual(json.loads(embedded), report)

    def check_hover(self, name):
        """Points at the middle of the largest triangle of the layout, on which others may be stacked."""
        _, uvs, faces = read_obj(self.folder / f"{name}.uv.obj")
        corners = [[uvs[corner[1]] for corner in face] for face in faces]

        def area(t):
            return (t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0])

        wanted = max(range(len(faces)), key=lambda f: area(corners[f]))
        u, v = (sum(corner[i] for corner in corners[wanted]) / 3 for i in (0, 1))
        self.browser.evaluate("document.getElementById('layout').scrollIntoView({block: 'center'})")
        self.browser.settle()
        before = self.count_colors("layout")["pink"]
        x, y = self.browser.evaluate(f"pixelOfUV({u!r}, {v!r})")
        self.browser.move(x, y)
        hovered = int(self.browser.evaluate("document.body.dataset.hovered"))
        self.assertEqual(sorted(corners[hovered]), sorted(corners[wanted]))
        self.assertIn(f"Triangle {hovered:,}:", self.browser.evaluate("document.getElementById('hovered').textContent"))
        self.assertGreater(self.count_colors("layout")["pink"], before + 5)
        self.assertGreater(self.count_colors("surface")["pink"], 5)

    def check_page(self, name, text, *options):
        self.write(f"{name}.off", text)
        run = self.unwrap(f"{name}.off", "--html", f"{name}.html", "--json", f"{name}.json", "--quiet", "--effort", "fast",
                          *options)
        self.assertEqual(run.returncode, 0, run.stderr)
        report = json.loads((self.folder / f"{name}.json").read_text())
        for size, (width, height, is_dark) in SIZES.items():
            self.browser.open(self.folder / f"{name}.html", width, height, is_dark)
            for canvas in ("surface", "layout"):
                self.assertGreater(self.count_colors(canvas)["covered"], 0.05, canvas)
            self.assertLessEqual(self.browser.evaluate("document.documentElement.scrollWidth"), width)
            self.check_values(report)
            self.check_hover(name)
            if SCREENSHOTS:
                SCREENSHOTS.mkdir(parents=True, exist_ok=True)
                self.browser.screenshot(SCREENSHOTS / f"{name}-{size}.png")
            self.assertEqual(self.browser.messages, [])
        return report

    def test_no_webgl(self):
        """The layout and the measures are there, and a sentence; nothing that needs the surface."""
        self.write("sphere.off", to_off(sphere(3)))
        run = self.unwrap("sphere.off", "--html", "sphere.html", "--json", "sphere.json", "--quiet")
        self.assertEqual(run.returncode, 0, run.stderr)
        report = json.loads((self.folder / "sphere.json").read_text())
        self.browser = self.start_browser(["--disable-3d-apis"])
        is_shown = lambda id_: self.browser.evaluate(f"document.getElementById('{id_}').getClientRects().length > 0")
        for size, (width, height, is_dark) in SIZES.items():
            self.browser.open(self.folder / "sphere.html", width, height, is_dark)
            self.check_values(report)
            self.assertTrue(is_shown("no-surface"))
            self.assertIn("WebGL", self.browser.evaluate("document.getElementById('no-surface').textContent"))
            for id_ in ("surface", "reset", "up", "hovered"):
                self.assertFalse(is_shown(id_), id_)
            pictures = set()
            for shading in range(3):
                self.browser.evaluate(f"document.querySelectorAll('input[name=shading]')[{shading}].click()")
                self.browser.settle()
                covered = self.count_colors("layout")["covered"]
                canvas = self.browser.evaluate("[document.getElementById('layout').width, document.getElementById('layout').height]")
                side = min(canvas) / 1.16
                self.assertLess(abs(covered * canvas[0] * canvas[1] / side ** 2 - report["fill"]), 0.06)
                pictures.add(self.browser.evaluate("document.getElementById('layout').toDataURL()"))
            self.assertEqual(len(pictures), 3)
            if SCREENSHOTS:
                SCREENSHOTS.mkdir(parents=True, exist_ok=True)
                self.browser.screenshot(SCREENSHOTS / f"no-webgl-{size}.png")
            self.assertEqual(self.browser.messages, [])

    def test_up_axis(self):
        self.write("sphere.stl", to_text_stl(sphere(2)))
        self.write("sphere.off", to_off(sphere(2)))
        for name, options, up in (("sphere.off", (), "y"), ("sphere.stl", (), "z"), ("sphere.stl", ("--up", "x"), "x")):
            self.assertEqual(self.unwrap(name, "--html", "a.html", "--quiet", "--effort", "fast", *options).returncode, 0)
            self.browser.open(self.folder / "a.html", 1280, 900)
            self.assertEqual(self.browser.evaluate("document.getElementById('up').value"), up)
        pictures = set()
        for up in "xyz":  # the sphere is an ellipsoid with three different axes
            self.browser.evaluate(f"document.getElementById('up').value = '{up}';"
                                  "document.getElementById('up').dispatchEvent(new Event('change'))")
            self.browser.settle()
            pictures.add(self.browser.evaluate("document.getElementById('surface').toDataURL()"))
        self.assertEqual(len(pictures), 3)
        self.assertEqual(self.browser.messages, [])

    def test_words(self):
        """The plot has numbers on both axes, and what there is none of is not shown."""
        report = self.check_page("sphere", to_off(sphere(3)))
        for axis in ("energy", "length"):
            count = self.browser.evaluate(f"document.querySelectorAll('#tradeoff text.{axis}').length")
            self.assertGreaterEqual(count, 2 if len(report["tradeoff"]) > 1 else 0)
        self.assertEqual(report["polygons"], 0)
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('[data-key=polygons]').length"), 0)
        stretch = float(self.browser.evaluate("document.querySelector('[data-key=E_iso]').textContent").split(" ")[0])
        self.assertLess(abs(2 * ((1 + stretch / 100) ** 2 + (1 + stretch / 100) ** -2) - report["E_iso"]), 0.02)

    def test_no_handles(self):
        self.check_page("cow", cow())

    def test_handles(self):
        self.assertEqual(self.check_page("torus", to_off(ring(24)))["genus"], 1)

    def test_many_charts(self):
        self.assertEqual(self.check_page("parts", to_off(parts(12)))["charts"], 12)

    def texts(self, selector):
        return self.browser.evaluate(f"Array.from(document.querySelectorAll('{selector}'), e => e.textContent)")

    def test_distribution(self):
        """All quantiles, the worst charts, and the bounds that were asked for."""
        report = self.check_page("cow", cow(), "--max-distortion", "4.2", "--max-face-distortion", "12", "--face-quantile",
                                 "0.999", "--max-chart-distortion", "4.5")
        shown = self.texts("#distribution [data-key^=E_quantiles]")
        self.assertEqual(len(shown), len(report["E_quantiles"]))
        self.assertEqual(sorted(shown, key=lambda text: float(text.split()[0])), shown)
        self.assertEqual(len(self.texts("#distribution [data-key=charts_distortion]")), report["charts"])
        faces, charts = self.texts("#distribution tr.bound")
        self.assertIn("99.9 %", faces)
        self.assertTrue(faces.endswith("12"))
        self.assertIn("asked for", charts)
        self.assertEqual(self.texts("#tradeoff text.bound"), ["asked for"])
        self.assertIn("asked for 4.2", self.texts("[data-key=E_iso]")[0])

    def test_shared_places(self):
        """The worst charts come first, and parts on the same place are counted."""
        report = self.check_page("stacks", to_off(parts(12)), "--stack")
        means = [json.loads(value)["mean"] for value in self.browser.evaluate(
            "Array.from(document.querySelectorAll('[data-key=charts_distortion]'), e => e.dataset.value)")]
        self.assertEqual(means, sorted((chart["mean"] for chart in report["charts_distortion"]), reverse=True)[:8])
        self.assertIn("12 parts lie on 2 places", " ".join(self.texts("#words p")))

    def test_symmetry(self):
        report = self.check_page("symmetric", to_off(sphere(3)), "--symmetry", "x")
        self.assertEqual([abs(x) for x in report["symmetry"]["normal"]], [1, 0, 0])
        self.assertEqual(len(self.texts("[data-key^=symmetry]")), 3)

    def test_keyboard(self):
        self.check_page("sphere", to_off(sphere(3)))
        before = self.browser.evaluate("document.getElementById('surface').toDataURL()")
        self.browser.evaluate("document.getElementById('surface').focus()")
        for kind in ("keyDown", "keyUp"):
            self.browser.call("Input.dispatchKeyEvent", type=kind, key="ArrowLeft", code="ArrowLeft", windowsVirtualKeyCode=37)
        self.browser.settle()
        self.assertNotEqual(self.browser.evaluate("document.getElementById('surface').toDataURL()"), before)


main()
