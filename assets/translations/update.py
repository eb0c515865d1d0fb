"""Brings vitrine_de.ts up to date with the texts of the source; update.sh says how it is called."""

import glob
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cpp_texts import messages, sentences, tokens, translated_calls  # noqa: E402

TS = 'assets/translations/vitrine_de.ts'
PROGRAM = os.environ.get('VITRINE_PROGRAM', 'build/release/vitrine')

# Strings that look like texts but are not: shader source, formats, texts of the command line's help and of tests.
NO_TEXT = re.compile(r'[;{}]\s*\n|\bvec[234]\b|\bfloat \w|^\s*#|</?\w+>|\bvoid \w|^\w+ = |^  +\w|\bsampler|^[.:#*@]|^\{\d\}$|'
                     r'^[\w{}]+/[\w{}]|^[A-Z_]+ \{|^glb |^fs frag |^hdr exr|^tif tiff|^png jpg|^SceneStage|\buniform \w|\bconst \w+ \w+|^<|^--(?!.* .* )|&nbsp;|\\u00|^%|^[^A-Za-z{]*$')
# Files of which nothing is shown to people in the window or as an error, or only in English by purpose.
NOT_SHOWN = re.compile(r'/stability/|stability_|doctor_command|html_text|preset_schema|_page\.cpp|serve/(?!listener)|report|embed|'
                       r'image/oiio/(?!guarded|pdf_reader|read|row|write)|shell_word|chart_font|block_copies|_glsl\.cpp|'
                       r'install|framework/table/derive|museum/render_command|museum/exr_metadata|coat_mesh|card_mesh|png_chunks|table_json|passes_json|text/message\.h')
# Rooms in which every text for people is made by message(): no sentence is looked for there, and none may be left.
CONVERTED = ('render/files/', 'render/gl/', 'render/scene/', 'exhibits/jobs/sprite/palette_file', 'exhibits/jobs/sprite/sprite_description')
# Strings that look like sentences but are shown to nobody: keys, names, messages of asserts.
UNSHOWN = {'framebuffers made', 'icc icm', 'mp4 webm mov mkv avi apng', 'lesson export', 'constant buffers', 'the picture was abandoned', 'unknown error',
           '{1} (specialized)', 'expressionPower({1}, {2}', '(TIME + {1}', 'min({1}, min({2}, {3}))',
           '(gl_FragCoord.xy / iResolution.xy)', ' in {{1}, {2}', ', exact {1}', '{1} "self"\n', '{1}::MinFilter "{2}"\n',
           '{1}::WrapMode "{2}"\n', '    // The camera, around a point {1} m in front of it.\n', '2.0 * tangent / RENDERSIZE.y',
           'around + camera[2] * ({1} * {2})', '{1}#define GUEST_ROUNDS {2}u\n{3}', 'wav flac', 'mi mathvariant="bold"', 'mi mathvariant="normal"',
           'mo stretchy="false"',
           '// Variables of the form in which the shader was written.\n{1}'}
# Callees whose argument is no text for people.
SILENT = {'shader', 'at', 'value', 'find', 'contains', 'define', 'getenv', 'uniform', 'is_member_of', 'compare', 'starts_with',
          'ends_with', 'add_option', 'add_flag', 'add_subcommand', 'add_option_function', 'add_flag_function', 'type_name',
          'option_text', 'assert', 'message', 'addArgument', 'printf', 'add_flag_callback', 'group', 'description', 'footer', 'logic_error'}
WORD = re.compile(r'[A-Za-z]{2,}')


def is_sentence(text):
    plain = re.sub(r'\{\d\}', ' ', text)
    words = WORD.findall(plain)
    if NO_TEXT.search(text) or '\0' in text or not words:
        return False
    if len(words) == 1:
        # With a place, one word may be part of a sentence: "at {1}", "{1} ago".
        return bool(re.search(r'\{\d\}', text)) and ' ' in text.strip() and '/' not in text and '=' not in text
    return ' ' in text.strip()


def spelled_out(name):
    text = re.sub(r'([A-Z])', lambda m: ' ' + m.group(1).lower(), name).strip()
    return text[:1].upper() + text[1:]


def incomplete():
    """Folders of exhibits that do not say that they are complete: nothing of theirs needs German."""
    folders = set()
    for name in glob.glob('exhibits/*/*.h'):
        with open(name, encoding='utf-8') as file:
            source = file.read()
        if re.search(r'class \w+[^;{]*: public (Sdf)?Exhibit\b', source) and 'isComplete()' not in source:
            folders.add(os.path.dirname(name) + '/')
    return tuple(folders - {'exhibits/framework/', 'exhibits/kit/'})


def cpp_files(*folders):
    skipped = incomplete()
    for folder in folders:
        for name in sorted(glob.glob(folder + '/**/*', recursive=True)):
            if name.endswith(('.cpp', '.h')) and not name.startswith(skipped):
                with open(name, encoding='utf-8') as file:
                    yield name, file.read()


class Texts:
    """All texts in the order in which they were found: (English, disambiguation) -> plural, and the files of each."""

    def __init__(self):
        self.all = {}
        self.where = {}

    def add(self, text, where, comment=None, plural=False):
        key = (text, comment)
        if text.strip():
            self.all[key] = self.all.get(key, False) or plural
            files = self.where.setdefault(key, [])
            if where not in files:
                files.append(where)


def message_texts(texts):
    """What message() is given, where it is made."""
    for name, source in cpp_files('render', 'exhibits', 'app', 'ui'):
        for text, _ in messages(tokens(source)):
            if re.search(r'[A-Za-z]', re.sub(r'\{\d\}', '', text)):
                texts.add(text, name)


def unmarked():
    """Sentences of the converted rooms that message() does not make: "file: text"."""
    found = []
    for name, source in cpp_files(*[room.rstrip('/') for room in CONVERTED]):
        for text, line, before in sentences(tokens(source)):
            callee = before[-2] if len(before) > 1 and before[-1] == '(' else ''
            if callee not in SILENT and is_sentence(text) and text not in UNSHOWN:
                found.append('%s:%d: %s' % (name, line, text))
    return found


def window_texts(texts):
    for name, source in cpp_files('ui', 'app'):
        for text, comment, plural, _ in translated_calls(tokens(source)):
            texts.add(text, name, comment, plural)


def engine_texts(texts):
    for name, source in cpp_files('render', 'exhibits', 'app', 'ui'):
        if NOT_SHOWN.search(name) or name.startswith(CONVERTED):
            continue
        command = name.startswith('app/')
        for text, _, before in sentences(tokens(source)):
            callee = before[-2] if len(before) > 1 and before[-1] == '(' else ''
            if callee in SILENT:
                continue
            if before[-2:] == ['{', 'return'] and ('tryThis' in before or 'buttonText' in before):
                continue
            if not is_sentence(text) or text in UNSHOWN:
                continue
            if name.startswith('ui/') and 'Failure' not in before[-8:]:
                continue  # The window's own texts are marked by tr; what it throws is told as the engine's are.
            if command and 'Failure' not in before[-8:] and (not text.endswith('.') or text.endswith('...')) or text.startswith(('{"', '{1}"child')) or 'Exit codes' in text or text.startswith('\n'):
                continue  # The errors of the command line are translated; its help is not.
            texts.add(text, name)
    with open('assets/translations/more_texts.txt', encoding='utf-8') as file:
        for line in file:
            if line.strip() and not line.startswith('# '):
                texts.add(line.rstrip('\n'), 'more_texts.txt')


def fact_texts(texts):
    """Labels of the properties that jobs report: most are a single word, which engine_texts takes for a key."""
    for name, source in cpp_files('exhibits/jobs'):
        for label in re.findall(r'\{"([A-Z][^"]+)",', source):
            texts.add(label, name)


def exhibit_texts(texts):
    """Titles, summaries, plaques and buttons, as the exhibits' headers say them."""
    says = re.compile(r'(title|product|summary|tryThis|buttonText)\(\)\s*const\s*override\s*\{\s*return\s*((?:"(?:\\.|[^"\\])*"\s*)+);')
    for name, source in cpp_files('exhibits'):
        for which, literals in says.findall(source):
            text = ''.join(re.findall(r'"((?:\\.|[^"\\])*)"', literals)).replace('\\"', '"')
            text = {'tryThis': 'Try: %s', 'buttonText': 'E – %s'}.get(which, '%s') % text
            texts.add(text, name)


def table_texts(texts, known):
    """Labels, groups, help and choices of the rows; of the built program. Without it, those that are known stay."""
    if os.path.exists(PROGRAM):
        listed = json.loads(subprocess.run([PROGRAM, 'list', '--json'], check=True, capture_output=True).stdout)
        # A program of before has the list alone.
        for exhibit in listed['exhibits'] if isinstance(listed, dict) else listed:
            if not exhibit['complete']:
                continue
            for row in exhibit['parameters']:
                for text in [row['label'], label_in_group(row), row['group'], row['help']] + row['choices']:
                    texts.add(text, 'tables')
    else:
        for key, where in known.items():
            if where == 'tables':
                texts.add(key[0], 'tables', key[1])
    # Tables that the list does not show, and the numbers of the shapes.
    row = re.compile(r'\b(?:real|count|toggle|choice|color|direction|file|text)\(\s*"(\w+)"')
    for name, source in cpp_files('exhibits'):
        if name.endswith('_table.h') or name.endswith('_rows.h'):
            for text in row.findall(source):
                texts.add(spelled_out(text), name)
        if '_table' in name or '_rows' in name:
            for text in re.findall(r'\b(?:group|labeled)\("([^"]+)"', source):
                texts.add(text, name)
            for choices in re.findall(r'\bchoice\([^{;]*\{(\s*"[^}]*)\}', source):
                for text in re.findall(r'"([^"]+)"', choices):
                    texts.add(text, name)
            for text in re.findall(r'\breads\([^,]+,\s*"([^"]+)"', source):
                texts.add(text, name)
        if name.endswith('kinds.cpp'):
            for text in re.findall(r'(?:\b\w+\(|\{)"([a-z][A-Za-z]*)",', source):
                texts.add(spelled_out(text), name)


def preset_texts(texts):
    """Names and tags of the presets that come with the exhibits; their files are English."""
    for name in sorted(glob.glob('assets/presets/**/*.json', recursive=True)):
        with open(name, encoding='utf-8') as file:
            preset = json.load(file)
        for text in [preset.get('name', '')] + preset.get('tags', []):
            texts.add(text, 'presets')


def label_in_group(row):
    """Without the first word where the heading says it: as labelInGroup of exhibits/framework/table/parameters.cpp."""
    first, _, rest = row['label'].partition(' ')
    if rest and first.lower() in [word.lower() for word in row['group'].split(' ')]:
        return rest[:1].upper() + rest[1:]
    return row['label']


def read_ts():
    known, where, plural = {}, {}, {}
    if not os.path.exists(TS):
        return known, where
    for message in ElementTree.parse(TS).getroot().iter('message'):
        key = (message.findtext('source'), message.findtext('comment'))
        forms = [f.text or '' for f in message.find('translation').findall('numerusform')]
        known[key] = forms or [message.findtext('translation') or '']
        where[key] = message.findtext('extracomment') or ''
    return known, where


def escaped(text):
    return text.replace('&', '&amp;').replace('<', '&lt;').replace('>', '&gt;').replace('"', '&quot;')


def ts_text(texts, known):
    lines = ['<?xml version="1.0" encoding="utf-8"?>', '<!DOCTYPE TS>', '<TS version="2.1" language="de_DE" sourcelanguage="en">',
             '<context>', '    <name>vitrine</name>']
    for (text, comment), plural in sorted(texts.all.items(), key=lambda e: (e[0][0].lower(), e[0][0], e[0][1] or '')):
        forms = known.get((text, comment), [''])
        if plural and len(forms) == 1:
            forms = [forms[0], forms[0]]
        done = all(forms)
        lines.append('    <message numerus="yes">' if plural else '    <message>')
        lines += ['        <location filename="%s"/>' % where for where in texts.where[(text, comment)] if '/' in where]
        lines.append('        <source>%s</source>' % escaped(text))
        if comment:
            lines.append('        <comment>%s</comment>' % escaped(comment))
        if 'tables' in texts.where[(text, comment)]:
            lines.append('        <extracomment>tables</extracomment>')
        mark = '' if done else ' type="unfinished"'
        if plural:
            lines.append('        <translation%s>' % mark)
            lines += ['            <numerusform>%s</numerusform>' % escaped(f) for f in forms]
            lines.append('        </translation>')
        else:
            lines.append('        <translation%s>%s</translation>' % (mark, escaped(forms[0])))
        lines.append('    </message>')
    return '\n'.join(lines + ['</context>', '</TS>', ''])


def found_by_lupdate():
    """The window's texts as Qt's own tool finds them, where it is: none may be missing here."""
    tool = next((t for t in ('/usr/lib/qt6/bin/lupdate', shutil.which('lupdate6')) if t and os.path.exists(t)), None)
    if not tool:
        return []
    with tempfile.TemporaryDirectory() as folder:
        made = os.path.join(folder, 'found.ts')
        subprocess.run([tool, '-silent', 'ui', 'app', '-locations', 'none', '-target-language', 'de', '-ts', made],
                       check=True, capture_output=True)
        return [m.findtext('source') for m in ElementTree.parse(made).getroot().iter('message')]


def read_translations(names, texts, known):
    """Lines "English = German"; plural forms with " | " between; line ends are written as \\n."""
    by_text = {}
    for key in texts.all:
        by_text.setdefault(key[0], []).append(key)
    for name in names:
        with open(name, encoding='utf-8') as file:
            for number, line in enumerate(file, 1):
                line = line.rstrip('\n')
                if not line.strip() or line.startswith('## '):
                    continue
                if ' = ' not in line:
                    sys.exit('%s:%d: no " = " in this line' % (name, number))
                # The first " = " whose left side is a text: texts may hold one, too.
                parts = line.split(' = ')
                for k in range(1, len(parts)):
                    english = ' = '.join(parts[:k]).replace('\\n', '\n')
                    if english in by_text:
                        german = ' = '.join(parts[k:]).replace('\\n', '\n')
                        for key in by_text[english]:
                            known[key] = german.split(' | ') if texts.all[key] else [german]
                        break
                else:
                    print('%s:%d: not in the source: %s' % (name, number, parts[0]), file=sys.stderr)


def wrong_messages(known):
    """Messages whose German lacks a placeholder or holds English words."""
    texts, wrong = Texts(), []
    message_texts(texts)
    places = re.compile(r'\{=?(\d)\}')
    english = re.compile(r'\b(the|of|is|are|with|from|and|for|this|that|it|its|which|by|or|when|not|has|there)\b')
    for text, comment in texts.all:
        for german in known.get((text, comment), []):
            if set(places.findall(german)) != set(places.findall(text)):
                wrong.append('other placeholders: %s = %s' % (text, german))
            if english.search(german):
                wrong.append('English words: %s = %s' % (text, german))
    return wrong


def main(arguments):
    known, where = read_ts()
    texts = Texts()
    window_texts(texts)
    exhibit_texts(texts)
    table_texts(texts, where)
    preset_texts(texts)
    message_texts(texts)
    engine_texts(texts)
    fact_texts(texts)
    check = arguments == ['--check']
    read_translations([] if check else arguments, texts, known)
    made = ts_text(texts, known)
    if check:
        lacking = [key[0] for key in texts.all if key not in known or not all(known[key])]
        lacking += [text for text in found_by_lupdate() if not any(key[0] == text for key in known)]
        for text in lacking:
            print('no translation: ' + text.replace('\n', '\\n'))
        wrong = wrong_messages(known)
        for line in wrong + unmarked():
            print(line)
        return 1 if lacking or wrong or unmarked() else 0
    with open(TS, 'w', encoding='utf-8') as file:
        file.write(made)
    for line in unmarked():
        print(line)
    open_texts = [(where[0], key[0]) for key, where in texts.where.items() if not all(known.get(key, ['']))]
    for where, text in sorted(open_texts):
        print('%s\t%s' % (where, text.replace('\n', '\\n')))
    print('%d texts, %d to be translated' % (len(texts.all), len(open_texts)), file=sys.stderr)
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
