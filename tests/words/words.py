#!/usr/bin/env python3
"""words.py SOURCE-FOLDER: every text that a person reads, against the language of this program.

Phrases that no text may have, comments of headers included; one term for one thing in both languages;
at most 25 words a sentence and two sentences a text, one a note. Texts of core and ui come from the
translations, which a test compares with the sources. The guide names only files that exist.
"""

import re
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

# What no text says, and what it says instead.
ENGLISH = {
    r"(that|those) of": "repeat the noun",
    r"what (is(?! this)|it|there|they|was|stands)": "a noun",
    r"of it(?! is)": "name it",
    r"is (none|nothing)": "say what there is",
    r"(is|are) (told|said)|in words": "shows, warns, rejects",
    r"stands?|stood": "is, shows",
    r"least(?<!at least)": "minimum",
    r"greatest": "maximum",
    r"left over": "residual",
    r"mend(s|ed|ing)?": "correct",
    r"refus(e|es|ed|al|ing)": "reject, not accept",
    r"anew": "again",
    r"besides": "also",
    r"throw(s|n)? away": "discard",
    r"take(s|n)? over": "use",
    r"go(es)? on": "continue",
    r"as (it is|they are)": "unchanged",
    r"(can(not)?|could) be built|be built": "feasible, fits",
    r"amber": "yellow",
    r"scenes?": "module",
    r"for ever|for good": "permanently",
    r"be rid of": "uninstall, remove",
    r"makes? least": "minimise",
    r"so (many|much|long)(?! as)": "name the number",
    r"nobody|nought": "say what there is",
    r"holds?|held": "has, contains, applies",
    r"(?<!under)lies?|lying": "is",
    r"asks? for|takes? up": "requires, absorbs",
    r"goes|gone": "moves, is removed",
    r"today[’']s": "present",
    r"(largest|smallest|heaviest|highest) less": "maximum minus minimum",
    r"as good as": "equal to",
    r"(is|are) no more than": "is only",
    r"paled?": "dimmed",
    r"put right": "correct",
}
RUSSIAN = {
    r"числа на замену": "заготовка",
    r"в пути": "ещё вычисляется",
    r"построить нельзя|нельзя построить|можно построить": "допустимо, недопустимо",
    r"отверг\w*": "не принято",
    r"наименее плох\w*": "лучший компромисс",
    r"рука (покоится|отпущена)": "ползунок отпущен",
    r"янтар\w*": "жёлтый",
    r"раздел(а|у|ом|е|ы|ов|ам|ами|ах)?": "модуль",
    r"перебалансировк\w*": "перебаланс",
    r"выбросить": "отменить, удалить",
    r"то ли это": "проверка",
    r"ничего нет": "что есть",
    r"не по листу": "результат устарел",
}
FOR_DEVELOPERS = {phrase: instead for phrase, instead in ENGLISH.items() if phrase != r"scenes?"}

# A term, and what its translation contains.
TERMS = {
    r"residual": r"остат|остал|остаё|ост\.",
    r"heavy spot": r"тяжёл\w* мест",
    r"balance factor": r"коэффициент\w* балансировки",
    r"overbalance": r"перебаланс",
    r"bob weights?": r"груз",
    r"Pareto": r"Парето",
    r"best compromise": r"лучш\w* компромисс",
    r"modules?": r"модул",
    r"misprint": r"опечатк",
    r"permissible residual": r"допустим\w* (остат|дисбаланс)",
    r"ignoring clearance": r"без учёта зазоров",
    r"sweep(?!,)": r"вариац",
    r"minimum": r"миним|мин\.",
    r"uncertain inputs?": r"неточн",
    r"case file": r"файл\w* задач",
}

# Rows of four cells, made of the fields, whose texts are read where they are translated.
FIELD_ROWS = r"^\| `" + 4 * r"(?:[^|\\\n]|\\\|)*\|" + "$"

LONGEST_SENTENCE = 25  # words
MOST_SENTENCES = 2

# Notes of pages and results, which have one sentence.
NOTE = (
    r'(?:captionLabel\(\s*(?:\w+::)?tr\(|notes\.(?:emplace|push)_back\([\s{]*Text::tr\()'
    r'((?:\s*"(?:[^"\\]|\\.)*")+)'
)

# Texts of more than two sentences on purpose: what a whole page, card or report says.
PROSE = {"ravnoves::ReportWords"}
METHODS_TEXT = r'Text::tr\(((?:\s*"(?:[^"\\]|\\.)*")+)'

# Words of the trade and of contracts that contain a phrase.
ALLOWED = re.compile(
    r"`[^`]*`"  # keys and commands
    r"|ravnoves\\?-cli solve|What[’']s [Tt]his|at least"
)

faults = 0


def fault(place, text, reason):
    global faults
    faults += 1
    print(f"FAULT: {place}: {reason}: {text[:160]!r}")


def phrases(place, text, language):
    plain = ALLOWED.sub(" ", text)
    for phrase, instead in language.items():
        for found in re.finditer(rf"(?<![\w-])(?:{phrase})(?![\w-])", plain, re.IGNORECASE):
            around = plain[max(0, found.start() - 50) : found.end() + 40].replace("\n", " ")
            fault(place, around, f"“{found.group(0)}” ({instead})")


def sentences(text):
    text = re.sub(r"\b(Fig|eq|e\.g|i\.e|рис|табл|см|макс|мин|ед)\.", r"\1", text)
    return [s for s in re.split(r"(?<=[.!?;:])\s+|\n", text) if re.search(r"\w", s)]


def words(sentence):
    return [word for word in sentence.split() if re.search(r"[^\W\d_]", word)]


def lengths(place, text, most=None):
    for sentence in sentences(ALLOWED.sub(" ", text)):
        if len(words(sentence)) > LONGEST_SENTENCE:
            fault(place, sentence, f"{len(words(sentence))} words in a sentence")
    full = [s for s in re.split(r"(?<=[.!?])\s+", text) if len(words(s)) > 2]
    if most and len(full) > most:
        fault(place, text, f"{len(full)} sentences")


def paragraphs(markdown):
    """Prose of a page: no code, no pictures, no tables of keys; a cell is a text of its own."""
    markdown = re.sub(r"```.*?```|^    .*?$|<!--.*?-->|!\[|\]\([^)]*\)", " ", markdown, flags=re.S | re.M)
    for paragraph in re.split(r"\n\s*\n|\n(?=\s*(?:[-|#]|\d+\. ))", markdown):
        for cell in paragraph.split("|") if paragraph.lstrip().startswith("|") else [paragraph]:
            if cell.strip():
                yield " ".join(cell.split())


def terms(place, english, russian):
    for term, translation in TERMS.items():
        if re.search(rf"(?<![\w-]){term}(?![\w-])", english, re.IGNORECASE):
            if not re.search(translation, russian, re.IGNORECASE):
                fault(place, russian, f"“{term}” is translated by another term")


def page(path, language, generated=None):
    text = path.read_text(encoding="utf-8")
    if generated:
        text = re.sub(generated, "", text, flags=re.M)
    count = 0
    for paragraph in paragraphs(text):
        count += 1
        phrases(path.name, paragraph, language)
        lengths(path.name, paragraph)
    if not count:
        fault(path.name, "", "no text was found")


def literals_of(form, *folders):
    """The texts that stand in the form in the sources of the folders."""
    found = set()
    for path in [path for folder in folders for path in folder.rglob("*.cpp")]:
        for literals in re.findall(form, path.read_text(encoding="utf-8")):
            parts = re.findall(r'"((?:[^"\\]|\\.)*)"', literals)
            found.add("".join(parts).replace('\\"', '"').replace("&", ""))
    if len(found) < 20:
        fault("texts of one form", form, "too few were found")
    return found


def comments(path):
    """Each comment of a header as one text, its lines joined."""
    found = re.findall(r"(?<!:)//[/<]*(?: @param \w+)?(.*)(\n *(?=//))?", path.read_text(encoding="utf-8"))
    return "".join(text + (" " if more else "\n") for text, more in found).split("\n")


def guide(path, source):
    page(path, FOR_DEVELOPERS)
    folders = "app core packaging resources tests ui".split()
    for name in re.findall(r"`([^`\n]+)`", path.read_text(encoding="utf-8")):
        is_path = re.fullmatch(r"[\w./-]+", name) and name.split("/")[0] in folders
        if is_path and not re.search(r"(?<![A-Z])[A-Z]{2,}(?![A-Z])", name) and not (source / name).exists():
            fault(path.name, name, "does not exist")


def main(source):
    texts = 0
    of_one_sentence = literals_of(NOTE, source / "core", source / "ui")
    prose = literals_of(METHODS_TEXT, source / "core/methods")
    for context in ET.parse(source / "resources/translations/ravnoves_ru.ts").getroot().iter("context"):
        name = context.findtext("name")
        for message in context.iter("message"):
            texts += 1
            english = message.findtext("source").replace("&", "")
            most = 1 if english in of_one_sentence else MOST_SENTENCES
            most = None if name in PROSE or english in prose else most
            phrases(name, english, ENGLISH)
            lengths(name, english, most)
            translation = message.find("translation")
            for russian in [translation.text] if len(translation) == 0 else [f.text for f in translation]:
                russian = (russian or "").replace("&", "")
                phrases(name, russian, RUSSIAN)
                lengths(name, russian, most)
                terms(name, english, russian)
    if texts < 1000:
        fault("translations", "", "too few texts were found")

    for path in sorted((source / "app").rglob("*.cpp")):
        for literal in re.findall(r'"((?:[^"\\\n]|\\.)*)"', path.read_text(encoding="utf-8")):
            if " " in literal:
                phrases(path.name, literal, ENGLISH)
    for path in sorted((source / "resources/help").glob("*.md")):
        page(path, RUSSIAN if path.name.endswith(".ru.md") else ENGLISH, FIELD_ROWS)
    for path in [*(source / "core").rglob("*.h"), *(source / "ui").rglob("*.h")]:
        for comment in comments(path):
            phrases(path.name, comment, FOR_DEVELOPERS)
    page(source / "README.md", ENGLISH)
    guide(source / "resources/developing.md", source)
    for path in sorted((source / "packaging/man").glob("*.1")):
        roff = re.sub(r"^\.\\\".*$|^\.[A-Z]+ ?|\\f[A-Z]|\\\||\\&", "", path.read_text(encoding="utf-8"), flags=re.M)
        phrases(path.name, roff.replace("\\-", "-"), ENGLISH)

    for part in ET.parse(next((source / "packaging/desktop").glob("*.metainfo.xml"))).iter():
        language = RUSSIAN if part.get("{http://www.w3.org/XML/1998/namespace}lang") == "ru" else ENGLISH
        phrases("metainfo", part.text or "", language)
        lengths("metainfo", part.text or "")

    if faults:
        print(f"{faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
