"""Reads and writes Qt Linguist's .ts files; core's texts use the same form as the window's."""
import xml.etree.ElementTree as ElementTree
from xml.sax.saxutils import escape


def read(path):
    """[(context, source, translation, type)] of a .ts file; nothing of one that is not there."""
    if not path.exists():
        return []
    rows = []
    for context in ElementTree.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            forms = [form.text or "" for form in translation.iter("numerusform")]
            text = "\n".join(forms) if forms else translation.text or ""
            rows.append((context.findtext("name"), message.findtext("source"), text, translation.get("type", "")))
    return rows


def quoted(text):
    return escape(text, {'"': "&quot;"})


def write(path, rows, language):
    """Rows (context, source, translation); an empty translation is unfinished. Ordered, so that merges are easy."""
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>", f'<TS version="2.1" language="{language}">']
    last = None
    for context, source, translation in sorted(rows):
        if context != last:
            if last is not None:
                lines.append("</context>")
            lines += ["<context>", f"    <name>{escape(context)}</name>"]
            last = context
        body = quoted(translation)
        lines += [
            "    <message>",
            f"        <source>{quoted(source)}</source>",
            f"        <translation>{body}</translation>" if translation else '        <translation type="unfinished"></translation>',
            "    </message>",
        ]
    if last is not None:
        lines.append("</context>")
    lines.append("</TS>")
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
