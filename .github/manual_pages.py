"""The pages of the site that `make manual` builds: those of `deltacal manual`, with their pictures."""

from __future__ import annotations

import re
from typing import Any

from mkdocs.structure.files import File, Files

from deltacal_gen.pages import manual

PICTURES = ("examples/*/*", "manual/measured/*")


def on_config(config: Any) -> Any:
    """List the pages in the order of the manual's contents."""
    titles = {topic: manual.read(topic).title for topic in manual.topics()}
    parts = [{part: [{titles[t]: f"{t}.md"} for t in topics]} for part, topics in manual.parts().items()]
    config.nav = [{"Contents": f"{manual.CONTENTS}.md"}, *parts]
    return config


def on_files(files: Files, config: Any) -> Files:
    """Return all pages as Markdown, measured tables and notebooks included, and the pictures."""
    found = [File.generated(config, f"{t}.md", content=_text(t)) for t in (manual.CONTENTS, *manual.topics())]
    package = manual.folder().parent
    for picture in (p for pattern in PICTURES for p in sorted(package.glob(pattern)) if p.suffix in (".png", ".svg")):
        name = picture.relative_to(package).as_posix().removeprefix("manual/")
        found.append(File.generated(config, name, abs_src_path=str(picture)))
    return Files(found)


def _text(topic: str) -> str:
    """Return a page whose links lead to pages of the site."""
    text = re.sub(r"\]\(([\w-]+)\.py(#[\w-]+)?\)", r"](\1.md\2)", manual.read(topic).text)
    return text.replace("](../examples/", "](examples/")
