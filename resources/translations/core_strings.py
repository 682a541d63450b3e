"""Which texts of the tree go through core's catalogue: what core tells people, and the tables of the window."""
import re
from pathlib import Path

from cpp_source import grouped, literal, segments, templates, tokens

HERE = Path(__file__).resolve().parent
#: Whoever runs these reads English: the simulator, and the tables that compare methods.
LEFT_OUT = ("core/simulation/", "core/survey/", "core/report/AccuracyCsv", "core/report/MeasurementsCsv", "core/report/ResultsJson")
#: Texts for machines: SQL, XML, reference systems, file signatures.
MACHINE = re.compile(
    r"^(SELECT|INSERT|UPDATE|DELETE|CREATE|PRAGMA|BEGIN|<|type=|PROJCS|PROJCRS|# vtk|application/)|_m,|=\"|^[A-Z0-9_ ]+$|^(vestige|user|Qt|Vestige)( %1)?$"
    r"|^# \.PCD|^ply\n|^element (vertex|face) %1|^element NAME|^property (TYPE|%1)|^ASTM E57|^laszip encoded$"
    r"|^visual reference$|^minimum <= "
)
MACHINE_CALLS = {"static_assert", "logic_error", "starts_with", "ends_with", "getenv", "regex"}
#: Whatever they are given is shown.
SHOWN_CALLS = {"say", "said", "translated", "progress", "message"}
#: In the window, whose own texts are in tr(): what goes into the history, to a job or into an Error.
WINDOW_CALLS = {"setMeasurement", "changeLayer", "restoreState", "begin", "change", "fail", "failed"}
#: Rooms that paint: they have no tr(), everything that reads like a text is one.
PAINTED = ("ui/view/", "ui/print/", "ui/charts/")
#: Join a number and a noun.
COUNTING_CALLS = {"counted", "howMany"}
WORD = re.compile(r"[A-Za-z][A-Za-z']+")
#: What joins a text to the one before it; core/base/Translation takes texts apart there.
JOINT = re.compile(r"^[.;:,] +")
KEY = re.compile(r"[a-z0-9_./-]+")


def is_prose(template, relative):
    pieces = "".join(template.literals)
    words = WORD.findall(" ".join(template.literals))
    if not words or MACHINE.search(template.text) or template.call in MACHINE_CALLS or "\0" in pieces:
        return False
    if template.call in SHOWN_CALLS:
        return True
    if relative.startswith("core/report/") and not KEY.fullmatch(pieces):
        return True
    if " " not in pieces:
        return False
    return len(words) > 1 or ("%" in template.text and max(map(len, words)) > 3)


def in_window(template, relative):
    if template.call in SHOWN_CALLS:
        return True
    if template.call in ("tr", "QT_TR_NOOP") or MACHINE.search(template.text):
        return False
    if template.call in WINDOW_CALLS:
        return " " in template.text or is_prose(template, relative)
    if template.call == "" and relative.startswith("ui/document/"):
        return is_prose(template, relative)
    return relative.startswith(PAINTED) and is_painted(template)


def is_painted(template):
    text = template.text
    return not re.search(r"[;{}#=/]|^[a-z_]+$|Inter|WenQuanYi|Liberation|DejaVu|PNG|^GL", text) and (
        text[:1].isupper() or len(WORD.findall(text)) > 1
    )


def is_label(template):
    """Of a parameter table: labels and helps begin with a capital, keys do not."""
    return template.text[:1].isupper()


def action_rows(source):
    """Menu, text and help of the rows {"group.name", menu, text, help, ...}."""

    def visit(group):
        if group.value == "{":
            cells = [cell for cell in segments(group.inside)]
            texts = [literal(cell) for cell in cells]
            if len(texts) > 3 and all(texts[:4]) and re.fullmatch(r"[a-z]+\.[a-z0-9-]+", texts[0].value):
                for text in texts[1:4]:
                    yield text.value
        for token in group.inside:
            if token.kind == "group":
                yield from visit(token)

    yield from visit(grouped(tokens(source)))


def choices(source):
    """The choices of parameters: {"none", "mean"}."""
    for match in re.finditer(r'\{("[a-z][a-z0-9-]*"(?:,\s*"[a-z][a-z0-9-]*")+)\}', source):
        yield from re.findall(r'"([^"]+)"', match.group(1))


def words():
    for line in (HERE / "words.txt").read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            yield line


def room_of(relative):
    return "/".join(relative.split("/")[:2])


def collect(root):
    """{text: room}, the room that says it first."""
    found = {}

    def add(text, room, exact=False):
        if not exact:
            text = JOINT.sub("", text.strip(" \n"))
        if re.search(r"[A-Za-z]", text):
            found.setdefault(text, room)

    for path in sorted(root.glob("core/**/*")) + sorted(root.glob("ui/**/*")):
        relative = path.relative_to(root).as_posix()
        if path.suffix not in (".cpp", ".h") or relative.startswith(LEFT_OUT):
            continue
        source = path.read_text(encoding="utf-8")
        room = room_of(relative)
        if relative.startswith("ui/"):
            if "ActionSpec" in source:
                for text in action_rows(source):
                    add(text, room)
            for template in templates(source):
                if in_window(template, relative):
                    add(template.text, room, template.call in SHOWN_CALLS)
            continue
        table = "const ParameterTable&" in source
        for template in templates(source):
            if template.call in COUNTING_CALLS and KEY.fullmatch(template.text.replace(" ", "_")):
                add(f"%1 {template.text}", room)
                add(f"%1 {template.text}s", room)
            elif is_prose(template, relative) or (table and is_label(template)):
                add(template.text, room, template.call == "say")
        if table:
            for text in choices(source):
                add(text, room)
    for text in words():
        add(text.lstrip("+"), "vocabulary" if text.startswith("+") else "words")
    return found
