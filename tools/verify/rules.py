"""The rules of kovacic-theorem/1: each is a module rule_NAME.py with the FIELDS of its data and said(theorem, step), which refuses what
does not follow."""
from importlib import import_module
from pathlib import Path

RULES = {path.stem.removeprefix("rule_").replace("_", "-"): import_module(path.stem)
         for path in sorted(Path(__file__).parent.glob("rule_*.py"))}
