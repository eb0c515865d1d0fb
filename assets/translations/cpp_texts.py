"""The texts of C++ files: what `tr` and `message` are given, and the sentences that are put together of literals and
values."""

import functools
import re

TOKEN = re.compile(
    r'\s+|//[^\n]*|/\*.*?\*/'
    r'|(?:u8|u|U|L)?R"(?P<delim>[^(\s]*)\(.*?\)(?P=delim)"'
    r'|(?:u8|u|U|L)?"(?:\\.|[^"\\\n])*"'
    r"|'(?:\\.|[^'\\\n])+'"
    r"|[A-Za-z_]\w*|\d[\w'.]*|->\*?|::|<<=?|>>=?|[-+*/%&|^=!<>]=|&&|\|\||\+\+|--|\.\.\.|.",
    re.S)

ESCAPES = {'n': '\n', 't': '\t', '"': '"', '\\': '\\', "'": "'", '0': '\0', 'r': '\r'}


def unescaped(literal):
    body = literal[literal.index('"') + 1:-1]

    def one(match):
        s = match.group(1)
        if s[0] in 'uU':
            return chr(int(s[1:], 16))
        if s[0] == 'x':
            return chr(int(s[1:], 16))
        return ESCAPES.get(s, s)
    return re.sub(r'\\(u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|x[0-9a-fA-F]+|.)', one, body, flags=re.S)


class Token:
    __slots__ = ('kind', 'text', 'line')

    def __init__(self, kind, text, line):
        self.kind, self.text, self.line = kind, text, line


@functools.lru_cache(maxsize=None)
def tokens(source):
    """Without comments, blanks and preprocessor lines; literals that stand side by side are one."""
    source = re.sub(r'^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', '', source, flags=re.M)
    made = []
    line = 1
    for match in TOKEN.finditer(source):
        t = match.group()
        first = line
        line += t.count('\n')
        if t.isspace() or t.startswith('//') or t.startswith('/*'):
            continue
        if t.endswith('"') and len(t) > 1 and '"' in t[:-1]:
            if 'R"' in t[:4]:
                made.append(Token('raw', t, first))
                continue
            text = unescaped(t)
            if made and made[-1].kind == 'text':
                made[-1].text += text
            else:
                made.append(Token('text', text, first))
        elif t[0].isalpha() or t[0] == '_':
            made.append(Token('name', t, first))
        elif t[0].isdigit():
            made.append(Token('number', t, first))
        else:
            made.append(Token('sign', t, first))
    return made


OPEN, CLOSE = '([{', ')]}'


def partner(all_tokens, i, step):
    """The bracket that belongs to that at i."""
    depth = 0
    while 0 <= i < len(all_tokens):
        t = all_tokens[i]
        if t.kind == 'sign':
            if t.text in OPEN:
                depth += 1
            elif t.text in CLOSE:
                depth -= 1
            if depth == 0:
                return i
        i += step
    return None


def translated_calls(all_tokens):
    """(text, disambiguation, plural, line) of every tr(), QT_TR_NOOP() and translate()."""
    for i, t in enumerate(all_tokens[:-2]):
        if t.kind != 'name' or all_tokens[i + 1].text != '(':
            continue
        at = i + 2
        if t.text in ('translate', 'QT_TRANSLATE_NOOP') and all_tokens[at].kind == 'text':
            at += 2  # Behind the context.
        elif t.text not in ('tr', 'QT_TR_NOOP'):
            continue
        if at >= len(all_tokens) or all_tokens[at].kind != 'text':
            continue
        text = all_tokens[at].text
        comment = None
        if all_tokens[at + 1].text == ',' and all_tokens[at + 2].kind == 'text' and all_tokens[at + 2].text:
            comment = all_tokens[at + 2].text
        yield text, comment, '%n' in text, t.line


def messages(all_tokens):
    """(text, line) of every message("...")."""
    for i, t in enumerate(all_tokens[:-2]):
        if t.kind == 'name' and t.text == 'message' and all_tokens[i + 1].text == '(' and all_tokens[i + 2].kind == 'text':
            yield all_tokens[i + 2].text, t.line


ENDS = {',', ';', '=', '?', ':', '+=', '<<', '>>', '&&', '||', '==', '!=', '<', '>', '<=', '>=', '(', '[', '{', ')', ']',
        '}', '!', '-', '*', '/', '%', '|', '&'}
WORDS_BEFORE = {'return', 'throw', 'case', 'co_return', 'else'}


def chain(all_tokens, i, end=None):
    """The operands of the sum that the literal at i, or the bracket from i to end, belongs to, as (first, last) pairs."""
    def operand_left(end):
        start = end
        while start >= 0:
            t = all_tokens[start]
            if t.kind == 'sign' and t.text in CLOSE:
                start = partner(all_tokens, start, -1)
                if start is None:
                    return None
            elif t.kind == 'sign' and t.text in ('+',) or t.kind == 'sign' and t.text in ENDS or t.text in WORDS_BEFORE:
                break
            start -= 1
        return start + 1

    def operand_right(start):
        end = start
        while end < len(all_tokens):
            t = all_tokens[end]
            if t.kind == 'sign' and t.text in OPEN:
                end = partner(all_tokens, end, 1)
                if end is None:
                    return None
            elif t.kind == 'sign' and (t.text == '+' or t.text in ENDS):
                break
            end += 1
        return end - 1

    left = operand_left(i if end is None else end)
    right = operand_right(i)
    if left is None or right is None:
        return None
    operands = [(left, right)]
    while left > 0 and all_tokens[left - 1].text == '+':
        start = operand_left(left - 2)
        if start is None or start > left - 2:
            break
        operands.insert(0, (start, left - 2))
        left = start
    while right + 1 < len(all_tokens) and all_tokens[right + 1].text == '+':
        end = operand_right(right + 2)
        if end is None or end < right + 2:
            break
        operands.append((right + 2, end))
        right = end
    return operands


def literal_of(all_tokens, first, last):
    """The text of an operand that is a literal, also within std::string() or text(); else None."""
    words = all_tokens[first:last + 1]
    if len(words) == 1 and words[0].kind == 'text':
        return words[0].text
    if len(words) == 6 and [w.text for w in words[:4]] == ['std', '::', 'string', '('] and words[4].kind == 'text':
        return words[4].text
    if len(words) == 4 and words[0].text == 'QStringLiteral' and words[2].kind == 'text':
        return words[2].text
    return None


MOST_FORMS = 12  # Most forms of one sentence whose parts are chosen by conditions.


def forms(all_tokens, first, last, done):
    """What a sum may be, each as a list of literals and None for what is no literal."""
    if first > last:
        return [[None]]
    made = [[]]
    for left, right in operands_within(all_tokens, first, last):
        literal = literal_of(all_tokens, left, right)
        if literal is not None:
            done.update(range(left, right + 1))
            made = [m + [literal] for m in made]
            continue
        branches = branches_of(all_tokens, left, right)
        parts = [[None]]
        if branches:
            inner = set()
            parts = [p for b in branches for p in forms(all_tokens, b[0], b[1], inner)]
            if all(p == [None] for p in parts) or len(parts) * len(made) > MOST_FORMS:
                parts = [[None]]
            else:
                done.update(inner)
        made = [m + p for m in made for p in parts]
    return made


def operands_within(all_tokens, first, last):
    start, depth = first, 0
    for i in range(first, last + 1):
        t = all_tokens[i]
        if t.kind == 'sign':
            depth += (t.text in OPEN) - (t.text in CLOSE)
            if depth == 0 and t.text == '+' and i > start:
                yield start, i - 1
                start = i + 1
    yield start, last


def branches_of(all_tokens, first, last):
    """Of "(condition ? this : that)" the two sides, and those of conditions within the second; else nothing."""
    if all_tokens[first].text != '(' or partner(all_tokens, first, 1) != last:
        return []
    found, at, depth = [], None, 0
    for i in range(first + 1, last):
        t = all_tokens[i]
        if t.kind != 'sign':
            continue
        depth += (t.text in OPEN) - (t.text in CLOSE)
        if depth:
            continue
        if t.text == '?' and at is None:
            at = i + 1
        elif t.text == ':' and at is not None:
            found.append((at, i - 1))
            at = None
            rest = i + 1
    if not found or at is not None:
        return []
    return found + [(rest, last - 1)]


def sentences(all_tokens):
    """(template, line, before) of all sums with a literal: {1}, {2} stand for what is no literal."""
    done = set()
    for i, t in enumerate(all_tokens):
        if t.kind != 'text' or i in done:
            continue
        # The literal of std::string("...") belongs to the sum around it.
        at = i
        if i >= 4 and [w.text for w in all_tokens[i - 4:i]] == ['std', '::', 'string', '(']:
            at = i - 4
        operands = chain(all_tokens, at)
        if operands is None:
            continue
        first, last = operands[0][0], operands[-1][1]
        if first > 0 and all_tokens[first - 1].text in ('?', ':') and in_sum(all_tokens, first - 1):
            continue  # It comes with the sentence that it is a part of.
        done.add(i)
        before = [w.text for w in all_tokens[max(0, first - 8):first]]
        for form in forms(all_tokens, first, last, done):
            text, places = '', 0
            for part in form:
                if part is not None:
                    text += part
                elif not text.endswith('{%d}' % places):
                    places += 1
                    text += '{%d}' % places
            yield text, t.line, before


def in_sum(all_tokens, i):
    """Whether the "?" or ":" at i stands in parentheses that are an operand of a sum with a literal."""
    depth = 0
    while i > 0:
        t = all_tokens[i]
        if t.kind == 'sign':
            depth += (t.text in CLOSE) - (t.text in OPEN)
            if depth < 0:
                break
        i -= 1
    if all_tokens[i].text != '(':
        return False
    end = partner(all_tokens, i, 1)
    if end is None or end + 1 >= len(all_tokens):
        return False
    if all_tokens[i - 1].text != '+' and all_tokens[end + 1].text != '+':
        return False
    if all_tokens[i - 1].kind == 'name' and all_tokens[i - 1].text not in WORDS_BEFORE:
        return False
    operands = chain(all_tokens, i, end)
    return bool(operands) and bool(branches_of(all_tokens, i, end)) and \
        len(forms(all_tokens, operands[0][0], operands[-1][1], set())) > 1
