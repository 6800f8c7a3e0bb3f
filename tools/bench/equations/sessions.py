"""One equation in one fresh session of another computer algebra system.

Each session first solves y'' = (x^2+3) y, so that nothing that is loaded on first use is measured; then it
repeats the question until 0.2 s of processor time are used, and prints the mean and the answer.
"""

import re
import resource
import subprocess
from dataclasses import dataclass, field

MEMORY = 4 << 30
START_UP = 5  # processor seconds for the start of a session, not counted


@dataclass
class Reply:
    end: str  # "answered", "time-out", "crash"
    seconds: float = 0.0
    claims: list = field(default_factory=list)  # {"y": ...} or {"polynomial": ...}; none: "no solution found"
    text: str = ""


def run(command, script, limit):
    """The output, or None with the reason.  The limit is processor time; a busy machine gets more."""
    def ceilings():
        resource.setrlimit(resource.RLIMIT_CPU, (limit + START_UP, limit + START_UP + 1))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    try:
        ran = subprocess.run(command, input=script, capture_output=True, text=True, errors="replace",
                             timeout=3 * limit + 60, preexec_fn=ceilings, start_new_session=True)
    except subprocess.TimeoutExpired:
        return None, "time-out"
    if ran.returncode in (-24, -9, 137, 152):
        return None, "time-out"
    return ran.stdout + ran.stderr, "answered"


def seconds_in(output):
    found = re.search(r"SECONDS[ ,\[]+([0-9.eE+-]+)", output)
    return float(found.group(1)) if found else None


class FriCAS:
    name = "FriCAS"
    package = "fricas"

    def ask(self, r, limit):
        r = re.sub(r"\bI\b", "%i", r.replace("z", "x"))
        script = f"""
)set messages type off
)set output algebra off
)set output length 245
y := operator 'y
now() == (GET_-INTERNAL_-RUN_-TIME()$Lisp) pretend Integer
now();
solve(D(y x, x, 2) = (x^2+3)*y x, y, x);
r := {r};
n := 0
t := now();
while now() - t < 20 repeat (s := solve(D(y x, x, 2) = r*y x, y, x); n := n + 1)
t := now() - t;
output(concat(["SECONDS ", unparse((t/(100*n))::Expression(Integer)::InputForm), " END"]))
if s case "failed" then output("NONE END") else output("FOUND END")
for b in s.basis repeat output(concat(["SOLUTION ", unparse(b::InputForm), " END"]))
)quit
"""
        output, end = run(["fricas", "-nosman", "-eval", ")set quit unprotected"], script, limit)
        if output is None:
            return Reply(end)
        joined = re.sub(r"\n +", "", output)
        found = re.search(r"SECONDS (\d+)(?:/(\d+))? ?END", joined)
        if not found:
            return Reply("crash", text=output[-300:])
        seconds = int(found.group(1)) / int(found.group(2) or 1)
        claims = [{"y": self.plain(y)} for y in re.findall(r"SOLUTION (.*?) ?END", joined)]
        return Reply("answered", seconds, claims)

    @staticmethod
    def plain(y):
        return y.replace("%i", "I").replace("pi()", "Pi").replace("'", "")


class Maxima:
    name = "Maxima"
    package = "maxima maxima-share"

    def ask(self, r, limit):
        r = re.sub(r"\bI\b", "%i", r.replace("z", "x"))
        script = f"""
display2d:false$ linel:10000000$ load("kovacicODE")$ DEBUGFLAG:0$
kovacicODE('diff(y,x,2)=(x^2+3)*y,y,x)$
n:0$ t:elapsed_run_time()$
while elapsed_run_time()-t < 0.2 do (s:kovacicODE('diff(y,x,2)=({r})*y,y,x), n:n+1)$
t:elapsed_run_time()-t$
printf(true,"~%SECONDS ~f~%",float(t/n))$
if s=false then printf(true,"NONE END~%") else
  for solution in s do for one in [[%k1=1,%k2=0],[%k1=0,%k2=1]] do
    printf(true,"SOLUTION ~a END~%",string(subst(one,rhs(solution))))$
quit()$
"""
        # the folder of kovacicODE is not on Maxima's search path in every installation
        path = 'file_search_maxima: append(file_search_maxima, ' \
               'map(lambda([d], sconcat(d, "/contrib/maxima-odesolve/###.mac")), [maxima_sharedir]))$\n'
        output, end = run(["maxima", "--very-quiet"], path + script.lstrip(), limit)
        if output is None:
            return Reply(end)
        seconds = seconds_in(output)
        if seconds is None:
            return Reply("crash", text=output[-300:])
        claims = [{"y": self.plain(y)} for y in re.findall(r"SOLUTION (.*?) END", output)]
        return Reply("answered", seconds, claims)

    @staticmethod
    def plain(y):
        for old, new in (("%e", "exp(1)"), ("%i", "I"), ("%pi", "Pi"), ("'", "")):
            y = y.replace(old, new)
        return y


class Giac:
    name = "Giac"
    package = "xcas"

    def ask(self, r, limit):
        r = re.sub(r"\bI\b", "i", r.replace("z", "x"))
        question = f"kovacicsols(y''=({r})*y,x,y)"
        script = f"""kovacicsols(y''=(x^2+3)*y,x,y):;
t:=time(sol:={question}):;
print("SECONDS",t):;
print("SOLUTION",string(sol),"END"):;
"""
        output, end = run(["giac"], script, limit)
        if output is None:
            return Reply(end)
        seconds = seconds_in(output)
        found = re.search(r"^SOLUTION,(.*?),END$", output, re.S | re.M)
        if seconds is None or not found:
            return Reply("crash", text=output[-300:])
        return Reply("answered", seconds, [c for c in self.claims(found.group(1).strip())], found.group(1))

    @staticmethod
    def claims(answer):
        answer = re.sub(r"\bi\b", "I", answer.replace("omega_", "omega"))
        if "Error" in answer:
            return
        if "omega" in answer:
            yield {"polynomial": answer}
            return
        if not answer.startswith("["):
            if answer not in ("0", ""):
                yield {"y": answer}
            return
        depth, start, body = 0, 0, answer[1:-1]
        for i, c in enumerate(body + ","):
            depth += c in "([" or -(c in ")]")
            if c == "," and depth == 0:
                if body[start:i].strip():
                    yield {"y": body[start:i].strip()}
                start = i + 1


SYSTEMS = [FriCAS(), Maxima(), Giac()]
