"""Scans on many processors: kovacic.scan."""

import concurrent.futures
import json
import os
import pathlib
import struct
import subprocess
import tempfile

from . import _core
from ._errors import Error, InvalidArgument, WrongType
from ._map import _ATTEMPTS, _command, _write_bytes


class Scan:
    r"""The matrix of a scan, read from a file NAME.npy.  For the eye: nothing here is a proof.

        >>> import pathlib, struct, tempfile
        >>> file = pathlib.Path(tempfile.mkdtemp()) / "plane.npy"
        >>> head = b"{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), }"
        >>> _ = file.write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head + struct.pack("<2d", 2, 3))
        >>> kovacic.Scan(file)
        <Scan: 1 x 2 cells>

    values: a numpy array where numpy is installed, else an array.array; the first axis side by side.  shape: as numpy has it,
    the last axis first.  nan: no orbit starts in the cell, inf: it ends early, in a singularity.
    """

    __slots__ = ("values", "shape", "path")

    def __init__(self, path):
        from ._section import column

        self.path = path
        data = path.read_bytes()
        head = 10 + struct.unpack("<H", data[8:10])[0]
        inside = data[10:head].decode().split("(")[1].split(")")[0]
        self.shape = tuple(int(n) for n in inside.split(",") if n.strip())
        self.values = column("d", data[head:])
        if hasattr(self.values, "reshape"):
            self.values = self.values.reshape(self.shape)

    def __repr__(self):
        return f"<Scan: {' x '.join(map(str, self.shape))} cells>"


def scan(path, *, scene=None, out=None, client=None, jobs=None, parts=None, command=None):
    """The matrix of the [scan] of a scene, in parts on many processors, each in a process of `kovacic section`.

        >>> scene = '''format = "equation/1"
        ... [system]
        ... kind = "hamiltonian"
        ... coordinates = ["x", "y"]
        ... momenta = ["u", "v"]
        ... hamiltonian = "(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3"
        ... [scene]
        ... section = "x"
        ... levels = { H = "1/12" }
        ... plot = ["y", "v"]
        ... crossings = 5
        ... scan = { of = "megno", over = { y = ["-1/5", "1/5", 60], v = ["-1/5", "1/5", 40] } }
        ... '''
        >>> import pathlib, tempfile
        >>> file = pathlib.Path(tempfile.mkdtemp()) / "plane.toml"
        >>> _ = file.write_text(scene)
        >>> kovacic.scan(file).shape
        (40, 60)

    path: of a file with a scene, or `scene` is the name of the one that is meant.  A Scan: `values`, `shape`, `path`
    (of the matrix NAME.npy).  The matrix is that of one process, bit by bit on processors of one kind.
    out: the directory of the matrix and of what is finished; a second call goes on from there.
    client: a dask.distributed.Client, whose workers read the same path; without one, `jobs` processes here (None: as many as
    there are processors).  parts: how many (None: four for each worker); one has whole blocks of 4096 cells.
    """
    if not isinstance(path, (str, os.PathLike)) or "\n" in str(path):
        raise WrongType("the path of a file is expected: workers read it")
    if parts is not None and (not isinstance(parts, int) or parts < 1):
        raise InvalidArgument(f"parts: a positive int is expected, and not {parts!r}")
    workers = len(client.nthreads()) if client is not None else jobs or len(os.sched_getaffinity(0))
    source = _core.Source("", str(pathlib.Path(path).resolve()))
    scenes = _core.system_scenes(source) if _core.has_system_scenes(source) else []
    if scene is None and len(scenes) > 1:
        scans = [s.name for s in scenes if s.is_scan]
        if len(scans) != 1:
            raise InvalidArgument(f"{len(scans)} scans: scene=... is one of {', '.join(scans)}")
        scene = scans[0]
    question = [str(pathlib.Path(path).resolve())] + (["--scene", scene] if scene is not None else [])
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary if out is None else out)
        folder.mkdir(parents=True, exist_ok=True)
        _run(client, workers, question, parts or 4 * workers, folder, command)
        about = json.loads(_section(question, folder, command, "--resume", "--format", "json", "--jobs", str(jobs or 1)))
        return Scan(folder / about["array"])


def _run(client, workers, question, parts, folder, command):
    numbers = range(1, parts + 1)
    if client is not None:
        from dask.distributed import as_completed
        futures = [client.submit(_part, question, k, parts, command, pure=False, retries=_ATTEMPTS) for k in numbers
                   if not any(folder.glob(f"*.{k}-of-{parts}.scan-part"))]
        try:
            for future in as_completed(futures):
                for name, data in future.result().items():
                    _write_bytes(folder / name, data)
        finally:
            client.cancel(futures)
        return
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        try:
            list(pool.map(lambda k: _section(question, folder, command, "--resume", "--part", f"{k}/{parts}"), numbers))
        finally:
            pool.shutdown(cancel_futures=True)


def _part(question, number, parts, command):
    """The journal of a part: {its name: its bytes}; runs wherever a worker is."""
    with tempfile.TemporaryDirectory() as folder:
        _section(question, folder, command, "--resume", "--part", f"{number}/{parts}")
        return {file.name: file.read_bytes() for file in pathlib.Path(folder).glob("*.scan-part")}


def _section(question, folder, command, *options):
    """Runs the command; after a kill again, which goes on from what is finished."""
    call = [command or _command(), "section", *question, "-o", str(folder), "--pictures", "none", "-q", "--timeout", "0", *options]
    for _ in range(_ATTEMPTS):
        done = subprocess.run(call, capture_output=True, encoding="utf-8")
        if done.returncode == 0:
            return done.stdout
        if done.returncode > 0:
            break
    raise Error(f"kovacic ended with {done.returncode}: {done.stderr.strip()}")
