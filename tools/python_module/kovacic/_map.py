"""Many questions on many processors: kovacic.map."""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import shutil
import subprocess

from ._errors import Error, InvalidArgument, WrongType

_ATTEMPTS = 4  # a chunk whose process was killed is asked again


def map(questions, *, out=None, client=None, jobs=None, chunk=32, options=(), command=None):
    """Answers to many questions, in their order, each asked in a supervised process of `kovacic solve --batch`.

    questions: objects with the keys of a batch ({"r": "z"}, {"ode": ..., "parameters": [...]}), or texts (r), or the path
    of a file with one such object on each line.  The answers are a list of objects of the format kovacic-result/1.

    out: the answers go into this file, one on each line.  What is finished is kept beside it, in `out`.parts, and a
    second call with the same questions goes on from there; the file itself appears when it is complete.
    client: a dask.distributed.Client; without one, `jobs` processes here (None: as many as there are processors).
    chunk: questions for one process.  options: of the command, for example ["--timeout", "10"].

        >>> [answer["group"]["type"] for answer in kovacic.map(["z", "z^2 + 3"])]
        ['SL2', 'Borel']
    """
    lines = _lines(questions)
    if not isinstance(chunk, int) or chunk < 1:
        raise InvalidArgument(f"chunk: a positive int is expected, and not {chunk!r}")
    options = [str(word) for word in options]
    chunks = [lines[i:i + chunk] for i in range(0, len(lines), chunk)]
    store = _Memory(len(chunks)) if out is None else _Parts(pathlib.Path(out), chunks, options)
    _run(client, jobs, store, chunks, options, command)
    return store.result()


def _lines(questions):
    if isinstance(questions, os.PathLike):
        return [line for line in pathlib.Path(questions).read_text(encoding="utf-8").split("\n") if line.strip()]
    if isinstance(questions, (str, bytes, dict)):
        raise WrongType("several questions are expected: a list, or the path of a file as pathlib.Path")
    return [_line(question) for question in questions]


def _line(question):
    if isinstance(question, str):
        question = {"r": question}
    if not isinstance(question, dict):
        raise WrongType(f"a question is a dict or a str (r), and not {question!r}")
    return json.dumps(question)


class _Memory:
    """The answers of the chunks, here."""

    def __init__(self, count):
        self.answers = [None] * count

    def missing(self):
        return range(len(self.answers))

    def keep(self, index, answers):
        self.answers[index] = answers

    def result(self):
        return [json.loads(line) for answers in self.answers for line in answers]


class _Parts:
    """The answers of the chunks in files of their own, named by what was asked; a file is there as a whole or not at all."""

    def __init__(self, out, chunks, options):
        self.out, self.folder = out, out.with_name(out.name + ".parts")
        self.folder.mkdir(parents=True, exist_ok=True)
        self.paths = [self.folder / f"{index:06}-{_digest([options, chunk])}.jsonl" for index, chunk in enumerate(chunks)]

    def missing(self):
        return [index for index, path in enumerate(self.paths) if not path.exists()]

    def keep(self, index, answers):
        _write(self.paths[index], "".join(line + "\n" for line in answers))

    def result(self):
        partial = self.out.with_name(self.out.name + ".partial")
        with open(partial, "wb") as merged:
            for path in self.paths:
                merged.write(path.read_bytes())
        os.replace(partial, self.out)
        shutil.rmtree(self.folder)
        return self.out


def _digest(value):
    return hashlib.sha256(json.dumps(value).encode()).hexdigest()[:16]


def _write(path, text):
    _write_bytes(path, text.encode("utf-8"))


def _write_bytes(path, data):
    partial = path.with_suffix(f".{os.getpid()}.partial")
    partial.write_bytes(data)
    os.replace(partial, path)


def _run(client, jobs, store, chunks, options, command):
    """Asks what is missing; each answer is kept as soon as it is there."""
    if client is not None:
        from dask.distributed import as_completed
        futures = {client.submit(_answers, chunks[i], options, command, pure=False, retries=_ATTEMPTS): i
                   for i in store.missing()}
        try:
            for future in as_completed(list(futures)):
                store.keep(futures[future], future.result())
        finally:
            client.cancel(list(futures))
        return
    with concurrent.futures.ThreadPoolExecutor(jobs or len(os.sched_getaffinity(0))) as pool:
        futures = {pool.submit(_answers, chunks[i], options, command): i for i in store.missing()}
        try:
            for future in concurrent.futures.as_completed(futures):
                store.keep(futures[future], future.result())
        finally:
            pool.shutdown(cancel_futures=True)


def _answers(lines, options, command):
    """The lines that the command answers; runs wherever a worker is."""
    call = [command or _command(), "solve", "--batch", "-", "--no-times", "--jobs", "1", *options]
    for _ in range(_ATTEMPTS):
        done = subprocess.run(call, input="".join(line + "\n" for line in lines), capture_output=True, encoding="utf-8")
        answers = done.stdout.splitlines()
        if done.returncode >= 0 and len(answers) == len(lines):
            return answers
        if done.returncode >= 0:  # it was not killed: it does not want to
            break
    raise Error(f"kovacic ended with {done.returncode} after {len(answers)} of {len(lines)} answers: {done.stderr.strip()}")


def _command():
    """The program: $KOVACIC, the one of the same build, or the one on the path."""
    beside = pathlib.Path(__file__).absolute().parents[2] / "tools" / "kovacic"
    found = os.environ.get("KOVACIC") or (str(beside) if os.access(beside, os.X_OK) and beside.is_file() else None)
    found = found or shutil.which("kovacic")
    if found is None:
        raise InvalidArgument("the program kovacic is not on the path; set KOVACIC, or command=")
    return found
