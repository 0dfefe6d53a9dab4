"""Checks that the built manual is complete: its links lead somewhere, and it shows without a network.

usage: check_links.py FOLDER

Prints each link whose file or anchor does not exist and each script, style or image on another site,
and exits with 1 if there is one. Links for the reader to other sites are not followed.
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urldefrag


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.needed, self.anchors = [], [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name"):
                self.anchors.add(value)
            elif name in ("href", "src"):
                self.links.append(value or "")
                if tag != "a":
                    self.needed.append(value or "")


def main():
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
        sys.exit(__doc__)
    folder = Path(sys.argv[1]).resolve()
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))}
    problems = 0
    for path, page in pages.items():
        for link in page.needed:
            if "//" in link and not link.startswith("data:"):
                print(f"{path.relative_to(folder)}: needs a network for {link}")
                problems += 1
        for link in page.links:
            if not link:
                print(f"{path.relative_to(folder)}: empty link")
                problems += 1
                continue
            if "://" in link or link.startswith(("javascript:", "mailto:", "data:")):
                continue
            file, anchor = urldefrag(link)
            target = (path.parent / unquote(file)).resolve() if file else path
            if not target.exists() or (anchor and target in pages and unquote(anchor) not in pages[target].anchors):
                print(f"{path.relative_to(folder)}: broken link to {link}")
                problems += 1
    print(f"{len(pages)} pages, {problems} problems")
    sys.exit(bool(problems) or not pages)


if __name__ == "__main__":
    main()
