"""XML written as text: elements with escaped attributes, in the order in which they are given."""

from __future__ import annotations

from planar_cli.homework.exports._text import xml

DECLARATION = '<?xml version="1.0" encoding="UTF-8"?>\n'


def element(name: str, /, *content: str, **attributes: str) -> str:
    """An element; its content is XML already."""
    whole = paired(name, *content, **attributes)
    return whole if any(content) else whole.removesuffix(f"></{name}>") + "/>"


def paired(name: str, /, *content: str, **attributes: str) -> str:
    """An element with both of its tags, as HTML wants it."""
    told = "".join(f' {key}="{xml(value)}"' for key, value in attributes.items())
    return f"<{name}{told}>{''.join(content)}</{name}>"
