"""A page with the verdicts and all charts, for wide and narrow windows alike."""

import html

STYLE = """body { font: 16px/1.4 sans-serif; margin: 1em auto; max-width: 60em; padding: 0 0.7em; }
article { border-top: 1px solid #ccc; padding: 0.5em 0; display: grid; grid-template-columns: 1fr 1fr; gap: 0 1em; }
article > * { margin: 0.2em 0; overflow-wrap: anywhere; }
h2, .why { grid-column: 1 / 3; font-size: 1em; }
.holds h2::after { content: " \\2014  holds"; color: #06703a; }
.fails h2::after { content: " \\2014  does not hold"; color: #a11; }
.open h2::after { content: " \\2014  not measured"; color: #666; }
img { width: 100%; height: auto; }
@media (max-width: 40em) { article { grid-template-columns: 1fr; } h2, .why { grid-column: 1; } }"""


def article(claim):
    kind = {True: "holds", False: "fails", None: "open"}[claim.holds]
    lines = [f"<article class={kind}><h2>{html.escape(claim.source)}: {html.escape(claim.statement)}</h2>",
             f"<p>Paper: {html.escape(claim.paper) or 'not said'}</p><p>Here: {html.escape(claim.ours) or 'nothing yet'}</p>"]
    if claim.reason:
        lines.append(f"<p class=why>Why: {html.escape(claim.reason)}</p>")
    return "\n".join(lines) + "</article>"


def write_page(folder, claims):
    charts = "\n".join(f"<figure><img src='{chart.name}' alt='{chart.stem}'><figcaption>{chart.stem.replace('_', ' ')}"
                       "</figcaption></figure>" for chart in sorted(folder.glob("*.svg")))
    (folder / "index.html").write_text(
        "<!DOCTYPE html><html lang=en><meta charset=utf-8><meta name=viewport content='width=device-width'>"
        f"<title>The paper's claims</title><style>{STYLE}</style><h1>The paper's claims</h1>\n"
        + "\n".join(map(article, claims)) + f"<h1>Charts</h1>\n{charts}</html>\n", encoding="utf-8")
