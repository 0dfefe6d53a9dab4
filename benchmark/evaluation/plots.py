"""Pictures by gnuplot. Each is written as NAME.gnuplot, with its data inside, and NAME.svg."""

import shutil
import subprocess
import sys


def write_plot(folder, name, set_up, series):
    """`series`: (title, rows of numbers, style) each. Without gnuplot, only its input is written."""
    series = [(title, data, style) for title, data, style in series if data]
    if not series:
        return
    blocks, parts = [], []
    for i, (title, data, style) in enumerate(series):
        blocks.append(f"$data{i} << END\n" + "\n".join(" ".join(map(repr, row)) for row in data) + "\nEND\n")
        parts.append(f"$data{i} {style_of(style)} title '{title}'")
    text = ("set terminal svg size 480,360 noenhanced font 'sans-serif,14' background rgb 'white'\n"
            f"set output '{name}.svg'\nset grid\n{set_up}\n" + "".join(blocks) + "plot " + ", ".join(parts) + "\n")
    script = folder / f"{name}.gnuplot"
    script.write_text(text, encoding="utf-8")
    if shutil.which("gnuplot"):
        run = subprocess.run(["gnuplot", script.name], cwd=folder, stderr=subprocess.PIPE, text=True, check=False)
        if run.returncode != 0:
            sys.exit(run.stderr)


def style_of(style):
    """Styles start with `using` or with how to draw."""
    return style if style.startswith("using") else f"with {style}"


def histogram(values, low, high, bins):
    """(middle, share) of each bin; what lies beyond the ends is in the outer bins."""
    width = (high - low) / bins
    counts = [0] * bins
    for value in values:
        counts[min(max(int((value - low) / width), 0), bins - 1)] += 1
    return [(low + (i + 0.5) * width, n / max(1, len(values))) for i, n in enumerate(counts)]


def cumulative(values):
    """The cumulative distribution as steps."""
    ordered = sorted(values)
    return [(value, (i + 1) / len(ordered)) for i, value in enumerate(ordered)]
