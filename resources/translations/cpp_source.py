"""The texts of C++ source: string literals, joined where the code joins them with +, as templates.

"only " + percent(x) + " of it" becomes the template "only %1 of it".
"""
import re
from dataclasses import dataclass, field

TOKEN = re.compile(
    r"""(?P<space>\s+|//[^\n]*|/\*.*?\*/|\\\n)
    |(?P<directive>^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*)
    |R"(?P<mark>[^(\s]*)\((?P<raw>.*?)\)(?P=mark)"
    |(?:u8|[uUL])?"(?P<text>(?:[^"\\\n]|\\.)*)"s?v?
    |'(?:[^'\\\n]|\\.)+'
    |(?P<number>\.?\d(?:[eEpP][+-]|'\d|[\w.])*)
    |(?P<name>[A-Za-z_]\w*)
    |(?P<sign>::|->|\+=|==|!=|<=|>=|&&|\|\||<<|\+\+|--|.)""",
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)
ESCAPES = {"n": "\n", "t": "\t", "r": "\r", "0": "\0", '"': '"', "'": "'", "\\": "\\"}
CLOSING = {"(": ")", "[": "]", "{": "}"}
#: Brackets after these hold the text itself.
WRAPPERS = {"string", "QString", "string_view", "fromUtf8", "QStringLiteral"}
MOST_WAYS = 16
#: What ends a text: nothing on its other side is joined to it.
SEPARATORS = {",", ";", "?", ":", "=", "+=", "==", "!=", "<<", "&&", "||", "return", "throw", "->", "<", ">"}


@dataclass
class Token:
    kind: str  # text, name, number, sign, group
    value: str
    line: int
    inside: list = field(default_factory=list)  # of a group


@dataclass
class Template:
    text: str
    line: int
    call: str  # the function whose argument it is, else empty
    literals: list  # its pieces of text


def unescape(text):
    """The characters that a literal stands for; UTF-8 byte escapes and universal names, too."""
    out = bytearray()
    at = 0
    while at < len(text):
        if text[at] != "\\":
            out += text[at].encode()
            at += 1
            continue
        code = text[at + 1]
        if code == "x":
            digits = re.match(r"[0-9a-fA-F]{1,2}", text[at + 2 :]).group()
            out.append(int(digits, 16))
            at += 2 + len(digits)
        elif code in "uU":
            size = 4 if code == "u" else 8
            out += chr(int(text[at + 2 : at + 2 + size], 16)).encode()
            at += 2 + size
        else:
            out += ESCAPES.get(code, code).encode()
            at += 2
    return out.decode("utf-8", "replace")


def tokens(source):
    found = []
    line = 1
    for match in TOKEN.finditer(source):
        kind = match.lastgroup
        if match["raw"] is not None:
            found.append(Token("text", match["raw"], line))
        elif match["text"] is not None:
            found.append(Token("text", unescape(match["text"]), line))
        elif kind in ("name", "number", "sign"):
            found.append(Token(kind, match.group(), line))
        elif kind is None:
            found.append(Token("number", match.group(), line))
        line += match.group().count("\n")
    return found


def grouped(flat):
    """The tokens with what stands in brackets inside group tokens, and adjacent literals as one."""
    root = Token("group", "", 0)
    stack = [root]
    for token in flat:
        if token.kind == "sign" and token.value in CLOSING:
            group = Token("group", token.value, token.line)
            stack[-1].inside.append(group)
            stack.append(group)
        elif token.kind == "sign" and token.value in CLOSING.values():
            if len(stack) > 1:
                stack.pop()
        else:
            last = stack[-1].inside[-1] if stack[-1].inside else None
            if token.kind == "text" and last is not None and last.kind == "text":
                last.value += token.value
            else:
                stack[-1].inside.append(token)
    return root


def segments(items):
    """Runs of tokens between separators; a block {} ends one, too."""
    run = []
    for token in items:
        if token.kind in ("sign", "name") and token.value in SEPARATORS:
            yield run
            run = []
        else:
            run.append(token)
    yield run


def parts(run):
    """The operands of + in a run."""
    part = []
    for token in run:
        if token.kind == "sign" and token.value == "+":
            yield part
            part = []
        else:
            part.append(token)
    yield part


def literal(part):
    """The literal that an operand is: "text", std::string("text"), QString::fromUtf8("text")."""
    if len(part) == 1 and part[0].kind == "text":
        return part[0]
    inside = wrapped(part)
    if inside and len(inside.inside) == 1 and inside.inside[0].kind == "text":
        return inside.inside[0]
    return None


def wrapped(part):
    """The group of an operand that is only brackets round something: (...), std::string(...), QString(...)."""
    if not part or part[-1].kind != "group" or part[-1].value != "(":
        return None
    if len(part) == 1 or part[-2].value in WRAPPERS:
        return part[-1]
    return None


def branches(items):
    """What a conditional may give, as runs; nothing where the items are no conditional and no sum."""
    runs = [[]]
    signs = []
    for token in items:
        if token.kind == "sign" and token.value in ("?", ":"):
            signs.append(token.value)
            runs.append([])
        elif token.kind in ("sign", "name") and token.value in (",", ";", "=", "return"):
            return []
        else:
            runs[-1].append(token)
    # A run before a question mark is a condition.
    return [run for run, sign in zip(runs, signs + [""]) if sign != "?"]


def readings(run):
    """The ways to read a sum: lists of pieces, a piece being a text or None for what is only known later."""
    ways = [[]]
    for part in parts(run):
        if not part:
            continue
        piece = literal(part)
        group = wrapped(part)
        options = [[None]]
        if piece:
            options = [[piece.value]]
            if group:
                group.kind = "read"
        elif group:
            inner = [way for branch in branches(group.inside) for way in readings(branch)]
            if any(piece is not None for way in inner for piece in way) and len(inner) * len(ways) <= MOST_WAYS:
                options = inner
                group.kind = "read"  # not visited again
        ways = [way + option for way in ways for option in options]
    return ways


def template_of(pieces):
    text = ""
    count = 0
    open_place = False
    for piece in pieces:
        if piece is not None:
            text += piece
            open_place = open_place and not piece
        elif not open_place:
            count += 1
            text += f"%{count}"
            open_place = True
    return text


def first_line(run):
    for token in run:
        if token.kind == "text":
            return token.line
        line = first_line(token.inside)
        if line:
            return line
    return 0


def templates(source):
    """Every Template of a source file, in order."""
    found = []

    def visit(group, call):
        for run in segments(group.inside):
            add(run, call)
            for index, token in enumerate(run):
                if token.kind == "group":
                    before = run[index - 1] if index else None
                    name = before.value if before and before.kind == "name" and token.value != "[" else ""
                    visit(token, name)

    def add(run, call):
        if len(run) > 1 and run[-1].kind == "text" and run[-2].kind in ("name", "group"):
            run = run[-1:]  # a declaration or condition before the literal is no part of it
        line = first_line(run)
        for pieces in readings(run):
            literals = [piece for piece in pieces if piece]
            if literals:
                found.append(Template(template_of(pieces), line, call, literals))

    visit(grouped(tokens(source)), "")
    return found
