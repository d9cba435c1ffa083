#!/usr/bin/python3
"""The documentation is a test: check_docs.py WHAT SOURCE [PROGRAM], WHAT being links,
citations, departures, installed, versions, tutorial, commands, examples, results, identifiers
or width."""

import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from fnmatch import fnmatch
from pathlib import Path

sys.dont_write_bytecode = True
from shown import missing_lines  # noqa: E402

FENCE = re.compile(r"^```(\S+)(?: (\S+))?\n(.*?)^```$", re.M | re.S)


def pages(source):
    found = [*source.glob("*.md"), *source.glob("docs/*.md"), *source.glob("decks/*/*.md"),
             *source.glob("validation/**/*.md")]
    assert len(found) > 10, found
    return found


def anchors(text):
    """Headings as forges name them: lower case, no punctuation, dashes for blanks."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def missing_paths(source, text):
    """Files of the tree named in backticks that are not there; * and {a,b} are patterns."""
    for path in re.findall(r"`((?:src|geometry|tests|docs|decks|validation|examples|packaging)/[\w./*{},-]+)`", text):
        forms = [path]
        while any("{" in form for form in forms):
            forms = [re.sub(r"\{[^}]*\}", part, form, count=1)
                     for form in forms for part in re.search(r"\{([^}]*)\}", form)[1].split(",")]
        yield from (form for form in forms
                    if not any(list(source.glob(form.rstrip("/") + ending)) for ending in ("", ".cpp", ".hpp")))


def check_links(source):
    """Every relative link points to a file, and its anchor to a heading there; files of
    the tree that are named in backticks exist."""
    return dead_links(source) + [f"{page}: no file {path}" for page in pages(source)
                                 for path in missing_paths(source, page.read_text())]


def check_installed(source, program):
    """The links between the pages that are installed, as they lie there."""
    with tempfile.TemporaryDirectory() as prefix:
        subprocess.run(["cmake", "--install", program.parents[1], "--prefix", prefix,
                        "--component", "program"], check=True, capture_output=True)
        return dead_links(Path(prefix, "share/doc/blocks"))


def dead_links(source):
    count, faults = 0, []
    for page in pages(source):
        for link in re.findall(r"\]\(([^)\s]+)\)", page.read_text()):
            if "://" in link:
                continue
            count += 1
            name, _, anchor = link.partition("#")
            target = page.parent / name if name else page
            if not target.exists():
                faults.append(f"{page}: no file {link}")
            elif anchor and anchor not in anchors(target.read_text()):
                faults.append(f"{page}: no heading {link}")
    assert count > 10, count
    return faults


def check_versions(source):
    """A release is one everywhere."""
    found = {name: re.search(form, (source / name).read_text(), re.M)[1] for name, form in {
        "CMakeLists.txt": r"^project\(blocks VERSION ([\d.]+)", "CITATION.cff": r"^version: ([\d.]+)$",
        "CHANGELOG.md": r"^## ([\d.]+)$", "docs/tutorial.md": r"blocks-([\d.]+)-linux", "README.md": r"blocks-([\d.]+)-linux",
        "docs/library.md": r"libblocks-dev_([\d.]+)-1_amd64.deb"}.items()}
    return [] if len(set(found.values())) == 1 else [f"versions differ: {found}"]


def sources(source):
    """The program's own text: code, scripts and tests."""
    folders = ("src", "geometry", "tests", "validation", "examples", "packaging", "docs", "decks")
    return [source / "go", source / "CMakeLists.txt",
            *(path for folder in folders for path in source.joinpath(folder).rglob("*")
              if path.suffix in (".hpp", ".cpp", ".py", ".sh", ".js", ".txt", ".md", ".deck"))]


def check_citations(source):
    """What comments cite is in the tree: pages, their headings, never the number of a rule."""
    count, faults, headings = 0, [], {}
    for path in sources(source):
        text = path.read_text(errors="replace")
        # A citation may be broken across two lines of a comment.
        for page, anchor in re.findall(r"\b(docs/[\w/-]+\.md)(?:#([\w-]+))?", text):
            count += 1
            target = source / page
            if not target.exists():
                faults.append(f"{path}: no page {page}")
            elif anchor and anchor not in headings.setdefault(page, anchors(target.read_text())):
                faults.append(f"{path}: no heading {page}#{anchor}")
        if "history" not in path.parts:
            faults += [f"{path}: {rule!r} is a number, not a name"
                       for rule in re.findall(r"\b[Rr]ules? \d+", text)]
    assert count > 60, count
    return faults


def check_departures(source, program):
    """The record of the report is complete: each card of its Appendix A exists, and
    docs/report-map.md lists the other cards. docs/departures.md names all cards that are not
    in the report or have fields that are not, and every tape of the report map."""
    cards = dict(re.findall(r"^### (\w+)\n(.*?)(?=^##)", (source / "docs/cards.md").read_text(), re.M | re.S))
    listed = subprocess.run([program, "cards"], text=True, capture_output=True).stdout
    assert list(cards) == re.findall(r"^  ([A-Z]\w+) ", listed, re.M), cards.keys()
    section = {name: re.search(r"\((?:.*; )?(not in the report|report A[\d.]+)\)", text)[1] for name, text in cards.items()}
    report_map, departures = ((source / f"docs/{page}.md").read_text() for page in ("report-map", "departures"))
    faults = [f"no card of report {number}" for number in
              [f"A.1.{n}" for n in range(1, 12)] + [f"A.2.{n}" for n in range(1, 22)]
              if f"report {number}" not in section.values()]
    new = {name for name, where in section.items() if where == "not in the report"}
    listed_new = set(re.findall(r"\b[A-Z][A-Z0-9]{2,}\b", re.split(r"\.\s", report_map.split("New are the cards")[1])[0]))
    faults += [f"docs/report-map.md, new cards: {name}" for name in sorted(new ^ listed_new)]
    wider = {name for name, text in cards.items() if "(not in the report)" in text}
    faults += [f"docs/departures.md does not name the card {name}" for name in sorted(new | wider)
               if not re.search(rf"\b{name}\b", departures)]
    tapes = set(re.findall(r"^\| (tape \d+)", report_map, re.M))
    assert len(tapes) == 3, tapes
    faults += [f"docs/departures.md does not name {tape}" for tape in sorted(tapes) if tape not in departures]
    return faults


def check_tutorial(source, program):
    """Decks are written, commands and Python run, and what is shown was printed."""
    return [fault for page in ("tutorial", "tutorial-map", "stability")
            for fault in faults_of_tutorial(source / f"docs/{page}.md", program)]


def faults_of_tutorial(page, program):
    environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}
    printed, faults, kinds = "", [], set()
    with tempfile.TemporaryDirectory() as folder:
        for kind, name, text in FENCE.findall(page.read_text()):
            kinds.add(kind)
            if kind == "deck":
                Path(folder, name).write_text(text)
                continue
            if kind == "text":
                faults += [f"{page}: not printed: {line}" for line in missing_lines(text, printed)]
                continue
            command = {"sh": ["sh", "-e", "-c", text], "python": [sys.executable, "-c", text]}[kind]
            done = subprocess.run(command, cwd=folder, env=environment, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            printed = done.stdout
            if done.returncode:
                return [*faults, f"{page}: exit code {done.returncode}:\n{text}{printed}"]
    assert {"sh", "text", "python"} <= kinds <= {"deck", "sh", "text", "python"}, kinds
    return faults


TWO_SQUARES = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
6
1 50 0 0
2 51 0 0
3 52 0 0
4 52 1 0
5 51 1 0
6 50 1 0
$EndNodes
$Elements
2
1 3 2 1 1 1 2 5 6
2 3 2 1 1 2 3 4 5
$EndElements
"""


def check_examples(source, program):
    """The example of every card runs: all of them one below the other, as they stand on
    the page; then RESTART goes on. The stress of INSITU does not fit these blocks, and the
    blocks do not come to rest in the steps of SOLVE, so these cards and FOS warn."""
    page = (source / "docs/cards.md").read_text()
    sections = re.findall(r"^### (\w+)\n(.*?)(?=^##)", page, re.M | re.S)
    examples = {name: re.search(r"^Example:\n\n```\n(.*?)^```$", text, re.M | re.S)[1] for name, text in sections}
    listed = subprocess.run([program, "cards"], text=True, capture_output=True).stdout
    assert list(examples) == re.findall(r"^  ([A-Z]\w+) ", listed, re.M), examples.keys()
    restart = examples.pop("RESTART")
    whole = "".join(examples.values())
    faults = [] if f"```\n{whole}```" in page.split("## The examples in one deck")[1] else ["the whole deck differs"]
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "mine.msh").write_text(TWO_SQUARES)
        Path(folder, "mapped.geojson").write_text(
            '{"type": "LineString", "coordinates": [[8, 3], [14, 6], [22, 7]]}')
        Path(folder, "crater.deck").write_text(whole)
        Path(folder, "on.deck").write_text(restart + examples["MOTION"])
        steps = 0
        for deck in ("crater.deck", "on.deck"):
            done = subprocess.run([program, "run", deck], cwd=folder, text=True, capture_output=True)
            warned = set(re.findall(r"warning: (\w+)", done.stderr)) - {"INSITU", "SOLVE", "FOS"}
            if done.returncode or warned:
                return [*faults, f"{deck}: exit code {done.returncode}\n{done.stderr}\n{whole}"]
            summary = json.loads(Path(folder, deck.replace("deck", "summary.json")).read_text())
            assert summary["steps"] > steps and summary["blocks"] > 12, summary
            steps = summary["steps"]
    return faults


def check_width(source):
    """Prose of a page is wrapped at 100 columns."""
    faults = []
    for page in [*source.glob("*.md"), *source.glob("docs/**/*.md"), *source.glob("decks/*/*.md")]:
        text = re.sub(r"^```.*?^```$", lambda block: "\n" * block[0].count("\n"), page.read_text(),
                      flags=re.M | re.S)
        faults += [f"{page}:{number}: {len(line)} columns" for number, line in enumerate(text.split("\n"), 1)
                   if len(line) > 100 and " " in line.strip() and not re.match(r"\||    |!\[", line)]
    return faults


def check_results(source, program):
    """The tables of docs/results.md name all datasets and keys that a run writes, with their
    shapes, and the Python on that page prints what it shows."""
    import h5py
    page = (source / "docs/results.md").read_text()
    names = lambda heading: re.findall(r"^\| (`.*?) \|(?: (\(.*?\)) \|)?", page.split(heading)[1].split("\n\n")[0], re.M)
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        deck = (source / "decks/stack/stack.deck").read_text()
        assert "\nMOTION" in deck
        Path(folder, "stack.deck").write_text(deck.replace("\nMOTION", "\nSPLANE, -99, 1, -99, 0\nHISTORY, 0.01, ke, y:13, unbalanced_ratio\nMOTION", 1))
        subprocess.run([program, "run", "stack.deck"], cwd=folder, check=True, capture_output=True)
        with h5py.File(Path(folder, "stack.vtkhdf")) as file:
            frames = file["VTKHDF/Steps"].attrs["NSteps"]
            for group in ("VTKHDF", "BLOCKS"):
                listed = {name.strip("`"): shape for name, shape in names(f"| dataset of `{group}` |")}
                found = {}
                file[group].visititems(lambda name, item: found.update(
                    {name: item.shape} if isinstance(item, h5py.Dataset) else {}))
                for name in sorted(found.keys() - listed.keys()):
                    if not re.match(r"Steps/", name):
                        faults.append(f"not on the page: {group}/{name}")
                faults += [f"not in the file: {group}/{name}" for name in listed if name not in file[group]]
                for name, shape in listed.items():
                    given = [part for part in shape.strip("()").split(", ") if part]
                    real = file[group][name].shape
                    if len(given) != len(real) or any(
                            int(n) != m for n, m in zip(given, real) if n.isdigit()) or (
                            given[:1] == ["s"] and real[0] != frames):
                        faults.append(f"{group}/{name}: {shape} on the page, {real} in the file")
        Path(folder, "laws.deck").write_text(
            deck.replace("\nMOTION", "\nJOINT, 1, 0.6\nJPAIR, 1, 1, 1\nMOTION", 1).replace("MOTION, 2", "MOTION, 0.01"))
        subprocess.run([program, "run", "laws.deck"], cwd=folder, check=True, capture_output=True)
        with h5py.File(Path(folder, "laws.vtkhdf")) as file:
            with_laws = {name.strip("`") for name, _ in names("| dataset of `BLOCKS`, with laws |")}
            more = {f"contacts/{name}" for name in file["BLOCKS/contacts"]} - found.keys()
            faults += [f"datasets with laws differ: {name}" for name in sorted(with_laws ^ more)]
        Path(folder, "cracks.deck").write_text(
            deck.replace("\nMOTION", "\nCRACK, 1, 1.E12, 0.01\nMOTION", 1).replace("MOTION, 2", "MOTION, 0.01"))
        subprocess.run([program, "run", "cracks.deck"], cwd=folder, check=True, capture_output=True)
        with h5py.File(Path(folder, "cracks.vtkhdf")) as file:
            listed = dict((name.strip("`"), shape) for name, shape in names("| dataset of `BLOCKS`, with cracks |"))
            shapes = {f"cracks/{name}": item.shape for name, item in file["BLOCKS/cracks"].items()}
            faults += [f"datasets with cracks differ: {name}" for name in sorted(listed.keys() ^ shapes.keys())]
            frames = file["VTKHDF/Steps"].attrs["NSteps"]
            for name in listed.keys() & shapes.keys():
                if shapes[name] != {"(n)": (0,), "(n, 3)": (0, 3), "(s)": (frames,)}[listed[name]]:
                    faults.append(f"{name}: {listed[name]} on the page, {shapes[name]} in the file")
            if "Parent" not in file["VTKHDF/CellData"]:
                faults.append("no Parent with cracks")
        laws_summary = json.loads(Path(folder, "laws.summary.json").read_text())
        if set(laws_summary["joint_contacts"]) != set(re.findall(r"`(\w+)`", page.split("there is also `joint_contacts`")[1])[:4]):
            faults.append("joint_contacts of the summary differs from the page")
        summary = json.loads(Path(folder, "stack.summary.json").read_text())
        keys = {key for name, _ in names("| key | unit | meaning |") for key in re.findall(r"`(\w+)`", name)}
        if keys != summary.keys():
            faults.append(f"keys of the summary differ: {sorted(keys ^ summary.keys())}")
        python, shown = (re.search(rf"^```{kind}\n(.*?)^```$", page, re.M | re.S)[1] for kind in ("python", "text"))
        done = subprocess.run([sys.executable, "-c", python], cwd=folder, text=True, capture_output=True)
        faults += [done.stderr] if done.returncode else [
            f"not printed: {line}" for line in missing_lines(shown, done.stdout)]
    return faults


def check_commands(source, program):
    """Command lines are accepted: run becomes check, a sweep runs nothing, figures lack
    their results."""
    count, faults = 0, []
    with tempfile.TemporaryDirectory() as folder:
        for page in [source / "README.md", *source.glob("decks/*/README.md")]:
            text = page.read_text()
            for line in re.findall(r"(?:^    |`)(?:blocks|\S*/go(?= run)) ([a-z]+ [^`\n]*)", text, re.M):
                line = re.sub(r"\[[A-Z]+\]", "", line).replace("DECK", "decks/stack/stack.deck")
                words = shlex.split(line, comments=True)
                if words[0] == "run":
                    words[0] = "check"
                elif words[0] == "fos":
                    words[:] = ["check", words[1]]
                elif words[0] == "sweep":
                    words.append("--dry-run")
                words = [re.sub(r"^.*decks/", f"{source}/decks/", word) for word in words]
                done = subprocess.run([program, *words], cwd=folder, text=True, capture_output=True)
                count += 1
                if done.returncode != (5 if words[0] in ("plot", "history", "view", "why", "import") else 0):
                    faults.append(f"{page}: {line}: exit code {done.returncode}\n{done.stderr}")
    assert count > 10, count
    return faults


def terms_explained_twice(glossary):
    """A term with a remark in brackets is the same term: it has one meaning."""
    heads = re.findall(r"^- (\*\*.*?): ", glossary, re.M | re.S)
    terms = [" ".join(term.split()).lower() for head in heads for term in re.findall(r"\*\*(.*?)\*\*", head, re.S)]
    assert heads, glossary
    return sorted({term for term in terms if terms.count(term) > 1})


def check_identifiers(source):
    """A name in code type that looks like one of the program is somewhere in its sources,
    and so is a path; the glossary explains each term once."""
    files = subprocess.run(["git", "ls-files"], cwd=source, text=True, capture_output=True,
                           check=True).stdout.split()
    paths = {parent.as_posix() for file in files for parent in [Path(file), *Path(file).parents]}
    known = {word for file in files if not file.endswith((".md", ".expected", ".wkt", ".geojson"))
             for word in re.findall(r"[a-zA-Z]\w*", Path(source, file).read_text(errors="replace")
                                    .replace("-D_", " "))}
    faults, count = [], 0
    for page in [source / "README.md", source / "CONTRIBUTING.md", *source.glob("docs/*.md")]:
        text = re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.M | re.S)
        for shown in re.findall(r"`([^`\s]+)`", text):
            named = re.findall(r"(?<![\w./])(?:src|geometry|tests|validation|packaging)/[\w/.*-]*[\w*]", shown)
            faults += [f"{page}: no file {name}" for name in named
                       if not any(fnmatch(path, name) or path.startswith(name + ".") for path in paths)]
            words = [] if named else re.findall(r"[a-zA-Z]\w*_\w+|\b[a-zA-Z]\w*[a-z][A-Z]\w*", shown)
            count += len(words)
            faults += [f"{page}: {word} is in no source" for word in words
                       if word not in known and word.removeprefix("fuzz_") not in known]
    assert terms_explained_twice("- **a** (of b): x\n- **c**, also **A**: y\n- **d**: z\n") == ["a"]
    faults += [f"the glossary explains {term} twice"
               for term in terms_explained_twice(Path(source, "docs/glossary.md").read_text())]
    assert count > 300, count
    return faults


def main():
    what, source, *program = sys.argv[1:]
    check = {"links": check_links, "citations": check_citations, "departures": check_departures, "installed": check_installed, "versions": check_versions, "tutorial": check_tutorial, "commands": check_commands, "examples": check_examples, "results": check_results, "identifiers": check_identifiers, "width": check_width}[what]
    faults = check(Path(source), *map(Path, program[:check.__code__.co_argcount - 1]))
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
