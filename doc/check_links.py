"""Checks that all links and images of the built manual lead somewhere.

usage: check_links.py FOLDER

Prints each link whose file or anchor does not exist, and exits with 1 if there is one. Links to other
sites are not followed.
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urldefrag


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name"):
                self.anchors.add(value)
            elif name in ("href", "src"):
                self.links.append(value or "")


def main():
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
        sys.exit(__doc__)
    folder = Path(sys.argv[1]).resolve()
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))}
    broken = 0
    for path, page in pages.items():
        for link in page.links:
            if not link:
                print(f"{path.relative_to(folder)}: empty link")
                broken += 1
                continue
            if "://" in link or link.startswith(("javascript:", "mailto:", "data:")):
                continue
            file, anchor = urldefrag(link)
            target = (path.parent / unquote(file)).resolve() if file else path
            if not target.exists() or (anchor and target in pages and unquote(anchor) not in pages[target].anchors):
                print(f"{path.relative_to(folder)}: broken link to {link}")
                broken += 1
    print(f"{len(pages)} pages, {broken} broken links")
    sys.exit(bool(broken) or not pages)


if __name__ == "__main__":
    main()
