"""The mutants of the Python checker: one operator, comparison, sign, constant, index, `and`/`or`/`not`, member of an `and` or
`or`, requirement or exception of a module of tools/verify changed at a time.  A mutant is called

    module.where: what stands there now @ the line of the source (2)

with a number if there are several of the same name.
Those that the patterns of mutants.txt fit change no rule; the reason stands beside each pattern."""
import ast
import copy
import fnmatch
import glob
import os
from collections import Counter, namedtuple

import traps

COMPARE = {ast.Lt: [ast.LtE, ast.Gt], ast.LtE: [ast.Lt, ast.GtE], ast.Gt: [ast.GtE, ast.Lt], ast.GtE: [ast.Gt, ast.LtE],
           ast.Eq: [ast.NotEq], ast.NotEq: [ast.Eq], ast.In: [ast.NotIn], ast.NotIn: [ast.In], ast.Is: [ast.IsNot],
           ast.IsNot: [ast.Is]}
OPERATOR = {ast.Add: [ast.Sub], ast.Sub: [ast.Add], ast.Mult: [ast.Add], ast.FloorDiv: [ast.Mult], ast.Div: [ast.Mult],
            ast.Mod: [ast.Mult], ast.Pow: [ast.Mult], ast.LShift: [ast.RShift], ast.RShift: [ast.LShift],
            ast.BitAnd: [ast.BitOr], ast.BitOr: [ast.BitAnd]}
SWAPPED = {"any": "all", "all": "any", "min": "max", "max": "min", "ceil": "floor", "floor": "ceil", "lcm": "gcd"}

# function: the path of names of the outermost function around the change, or None; code(): of this function, or of the module
Mutant = namedtuple("Mutant", "name module line function code")


def source(module):
    with open(os.path.join(traps.VERIFY, module + ".py"), encoding="utf-8") as f:
        return f.read()


def modules():
    """All that kovacic_verify imports, itself last: what is imported comes first."""
    found = []

    def visit(name):
        if name in found or not os.path.exists(os.path.join(traps.VERIFY, name + ".py")):
            return
        for node in ast.walk(ast.parse(source(name))):
            for x in [a.name for a in node.names] if isinstance(node, ast.Import) else [getattr(node, "module", None)]:
                visit(str(x))
        for path in sorted(glob.glob(os.path.join(traps.VERIFY, "rule_*.py"))) if name == "theorem" else ():
            visit(os.path.basename(path)[:-3])
        found.append(name)
    visit("kovacic_verify")
    return found


def shown(new):
    return " ".join(ast.unparse(ast.fix_missing_locations(new)).split())[:120]


def instead(node):
    """(another node, what stands there)"""
    if isinstance(node, ast.Compare):
        for i, op in enumerate(node.ops):
            for other in COMPARE[type(op)]:
                new = copy.copy(node)
                new.ops = [*node.ops[:i], other(), *node.ops[i + 1:]]
                yield new, shown(new)
    elif isinstance(node, ast.BinOp) and not is_text(node.left):
        for other in OPERATOR.get(type(node.op), []):
            new = ast.BinOp(node.left, other(), node.right)
            yield new, shown(new)
    elif isinstance(node, ast.BoolOp):
        new = ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)
        yield new, shown(new)
        for i in range(len(node.values)):
            rest = node.values[:i] + node.values[i + 1:]
            yield rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest), "without " + shown(node.values[i])
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub)):
        yield node.operand, f"{shown(node.operand)} for {shown(node)}"
    elif isinstance(node, (ast.If, ast.IfExp, ast.While)):
        new = copy.copy(node)
        new.test = ast.copy_location(ast.UnaryOp(ast.Not(), node.test), node.test)
        yield new, "not " + shown(node.test)
    elif isinstance(node, ast.AugAssign) and type(node.op) in OPERATOR:
        new = ast.AugAssign(node.target, OPERATOR[type(node.op)][0](), node.value)
        yield new, shown(new)
    elif isinstance(node, ast.Constant):
        if isinstance(node.value, bool):
            yield ast.Constant(not node.value), f"{not node.value} for {node.value}"
        elif isinstance(node.value, int):
            yield ast.Constant(node.value + 1), f"{node.value + 1} for {node.value}"
    elif isinstance(node, ast.Raise) or isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        yield ast.Pass(), "without " + shown(node)
    elif isinstance(node, ast.Name) and node.id in SWAPPED and isinstance(node.ctx, ast.Load):
        yield ast.Name(SWAPPED[node.id], ast.Load()), f"{SWAPPED[node.id]} for {node.id}"


def is_text(node):
    return isinstance(node, ast.JoinedStr) or isinstance(getattr(node, "value", 0), str)


class Finder(ast.NodeVisitor):
    """Collects (node, field, index, replacement, what, where, function) for one module."""

    def __init__(self):
        self.found, self.where, self.function = [], [], None        # function: path and node

    def visit(self, node):
        named, outer = isinstance(node, (ast.FunctionDef, ast.ClassDef)), self.function
        if named:
            self.where.append(node.name)
        for field, value in ast.iter_fields(node):
            if isinstance(node, ast.FunctionDef) and outer is None:
                self.function = (tuple(self.where), node) if field == "body" else None      # defaults are not in its code
            for i, child in enumerate(value if isinstance(value, list) else [value]):
                if isinstance(child, ast.AST) and not self.is_remark(field, child):
                    for new, what in instead(child):
                        self.found.append((node, field, i if isinstance(value, list) else None,
                                           ast.copy_location(new, child), what, ".".join(self.where), self.function))
                    self.visit(child)
        if named:
            self.where.pop()
        self.function = outer

    @staticmethod
    def is_remark(field, node):
        docstring = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        return isinstance(node, ast.JoinedStr) or field in ("decorator_list", "annotation") or docstring


def mutants(module):
    tree, lines = ast.parse(source(module)), source(module).splitlines()
    finder, seen = Finder(), Counter()
    finder.visit(tree)
    for parent, field, index, new, what, where, function in finder.found:
        def code(parent=parent, field=field, index=index, new=new, function=function):
            old = getattr(parent, field)
            setattr(parent, field, new if index is None else [*old[:index], new, *old[index + 1:]])
            try:
                if function is None:
                    return compile(ast.fix_missing_locations(tree), module + ".py", "exec")
                alone = compile(ast.fix_missing_locations(ast.Module([function[1]], [])), module + ".py", "exec")
                return next(x for x in alone.co_consts if getattr(x, "co_name", None) == function[1].name)
            finally:
                setattr(parent, field, old)
        name = f"{'.'.join(filter(None, (module, where)))}: {what} @ {lines[new.lineno - 1].strip()}"
        seen[name] += 1
        yield Mutant(name + f" ({seen[name]})" * (seen[name] > 1), module, new.lineno, function and function[0], code)


def equivalent():
    """{pattern: reason} from mutants.txt"""
    with open(os.path.join(traps.HERE, "mutants.txt"), encoding="utf-8") as f:
        rows = [line.rstrip("\n").partition("  # ") for line in f if line.strip() and not line.startswith("#")]
    return {pattern.rstrip(): reason for pattern, _, reason in rows}


def is_equivalent(mutant, patterns):
    return any(fnmatch.fnmatchcase(mutant.name, x) for x in patterns)
