"""The mutants of the Python checker: one operator, comparison, sign, constant, index, `and`/`or`/`not` or requirement of
a module of tools/verify changed at a time.  What is a limit of the work and no rule is left as it is."""
import ast
import copy
import os
import re

import traps

COMPARE = {ast.Lt: [ast.LtE, ast.Gt], ast.LtE: [ast.Lt, ast.GtE], ast.Gt: [ast.GtE, ast.Lt], ast.GtE: [ast.Gt, ast.LtE],
           ast.Eq: [ast.NotEq], ast.NotEq: [ast.Eq], ast.In: [ast.NotIn], ast.NotIn: [ast.In], ast.Is: [ast.IsNot],
           ast.IsNot: [ast.Is]}
OPERATOR = {ast.Add: [ast.Sub], ast.Sub: [ast.Add], ast.Mult: [ast.Add], ast.FloorDiv: [ast.Mult], ast.Div: [ast.Mult],
            ast.Mod: [ast.Mult], ast.Pow: [ast.Mult], ast.LShift: [ast.RShift], ast.RShift: [ast.LShift],
            ast.BitAnd: [ast.BitOr], ast.BitOr: [ast.BitAnd]}
SWAPPED = {"any": "all", "all": "any", "min": "max", "max": "min", "ceil": "floor", "floor": "ceil", "lcm": "gcd"}
UNTOUCHED = ("spend", "charge", "cost")     # estimates of work: limits, not rules;
LIMIT_NAMES = {"size", "most", "of_r", "length"}                # so is what these names get,
LIMIT = re.compile("too (large|many|much)|a limit")             # and what is required with such a reason


def source(module):
    with open(os.path.join(traps.VERIFY, module + ".py"), encoding="utf-8") as f:
        return f.read()


class Finder(ast.NodeVisitor):
    """Collects (node, field, index, replacement, what, where, function) for one module; function: the outermost one,
    whose code has the change, as a path of names."""

    def __init__(self):
        self.found, self.where, self.function = [], [], None

    def put(self, parent, field, index, new, what):
        self.found.append((parent, field, index, new, what, ".".join(self.where), self.function))

    def visit(self, node):
        named, outer = isinstance(node, (ast.FunctionDef, ast.ClassDef)), self.function
        if named:
            self.where.append(node.name)
        for field, value in ast.iter_fields(node):
            if isinstance(node, ast.FunctionDef) and outer is None:
                self.function = tuple(self.where) if field == "body" else None      # defaults are not in its code
            for i, child in enumerate(value if isinstance(value, list) else [value]):
                if isinstance(child, ast.AST) and not self.skipped(node, field, child):
                    self.mutate(node, field, i if isinstance(value, list) else None, child)
                    self.visit(child)
        if named:
            self.where.pop()
        self.function = outer

    @staticmethod
    def skipped(parent, field, node):
        if isinstance(node, ast.JoinedStr) or field in ("decorator_list", "annotation"):
            return True
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            return True                     # a docstring
        if isinstance(node, ast.Assign):
            names = {x.id for t in node.targets for x in ast.walk(t) if isinstance(x, ast.Name)}
            return bool(names) and names <= LIMIT_NAMES
        call = node.value if isinstance(node, ast.Expr) else node
        if isinstance(call, ast.Call):
            name = getattr(call.func, "id", getattr(call.func, "attr", ""))
            why = getattr(call.args[-1], "value", "") if name in ("need", "right") and call.args else ""
            return name in UNTOUCHED or isinstance(why, str) and bool(LIMIT.search(why))
        return isinstance(node, ast.FunctionDef) and node.name in UNTOUCHED

    def mutate(self, parent, field, index, node):
        def put(new, what):
            self.put(parent, field, index, ast.copy_location(new, node), what)
        if isinstance(node, ast.Compare):
            for i, op in enumerate(node.ops):
                for other in COMPARE[type(op)]:
                    new = copy.deepcopy(node)
                    new.ops[i] = other()
                    put(new, ast.unparse(new))
        elif isinstance(node, ast.BinOp):
            for other in OPERATOR.get(type(node.op), []):
                if not isinstance(node.left, (ast.JoinedStr, ast.Constant)) or not isinstance(
                        getattr(node.left, "value", 0), str):
                    new = ast.BinOp(node.left, other(), node.right)
                    put(new, ast.unparse(new))
        elif isinstance(node, ast.BoolOp):
            new = ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)
            put(new, ast.unparse(new))
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub)):
            put(node.operand, ast.unparse(node.operand) + " for " + ast.unparse(node))
        elif isinstance(node, (ast.If, ast.IfExp, ast.While)):
            new = copy.copy(node)
            new.test = ast.copy_location(ast.UnaryOp(ast.Not(), node.test), node.test)
            put(new, "not " + ast.unparse(node.test))
        elif isinstance(node, ast.AugAssign) and type(node.op) in OPERATOR:
            new = ast.AugAssign(node.target, OPERATOR[type(node.op)][0](), node.value)
            put(new, ast.unparse(new))
        elif isinstance(node, ast.Constant):
            if isinstance(node.value, bool):
                put(ast.Constant(not node.value), f"{not node.value} for {node.value}")
            elif isinstance(node.value, int):
                put(ast.Constant(node.value + 1), f"{node.value + 1} for {node.value}")
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            put(ast.Pass(), "without " + ast.unparse(node)[:200])
        elif isinstance(node, ast.Name) and node.id in SWAPPED and isinstance(node.ctx, ast.Load):
            put(ast.Name(SWAPPED[node.id], ast.Load()), f"{SWAPPED[node.id]} for {node.id}")


def mutants(module):
    """(name, line, its function, what makes the changed code object)"""
    tree = ast.parse(source(module))
    finder = Finder()
    finder.visit(tree)
    for parent, field, index, new, what, where, function in finder.found:
        def make(parent=parent, field=field, index=index, new=new):
            old = getattr(parent, field)
            if index is None:
                setattr(parent, field, new)
            else:
                old, value = old[index], old
                value[index] = new
            try:
                return compile(ast.fix_missing_locations(tree), module + ".py", "exec")
            finally:
                if index is None:
                    setattr(parent, field, old)
                else:
                    value[index] = old
        what = " ".join(what.split())
        yield f"{module}.{where}: {what}" if where else f"{module}: {what}", new.lineno, function, make
