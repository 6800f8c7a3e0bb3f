#!/usr/bin/python3
"""Completion for bash and zsh, from the --help of the program.

usage: completion.py PROGRAM bash|zsh
"""

import sys

from command_line import Program, listed

FILES = {"FILE", "FILE...", "FILE.jsonl", "CERT", "DIR", "DIR|FILE", "PROGRAM"}

BASH = r"""# bash completion of kovacic, made from its --help by tools/packaging/completion.py
_kovacic() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= words= operands= files= i
  for ((i = 1; i < COMP_CWORD; i++)); do
    if [[ ${COMP_WORDS[i]} != -* ]]; then
      command=${COMP_WORDS[i]}
      break
    fi
  done
  case "$command $before" in
@VALUES@  esac
  case $command in
@OPTIONS@    *) COMPREPLY=($(compgen -W "@COMMANDS@ --help --version" -- "$word")); return ;;
  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$word"))
  else
    COMPREPLY=($(compgen -W "$operands" -- "$word") $([[ $files ]] && compgen -f -- "$word"))
    compopt -o filenames 2>/dev/null
  fi
}
complete -F _kovacic kovacic
"""


def operands(command):
    """The words that stand for themselves in a place without a dash, and whether files may stand there."""
    words, files = [], not command.positionals
    for shown, meaning in command.positionals:
        name = shown.split(" ")[0]
        files = files or name in FILES
        if name not in FILES:
            words += listed(meaning) or [part.split(" ")[0] for part in meaning.split(", ") if "(" in part]
    return words, files and bool(command.positionals)


def bash(program):
    values, options = "", ""
    for command in program.commands:
        for option in command.options:
            if option.value:
                kind = f'-W "{" ".join(option.choices)}"' if option.choices else "-f" if option.value in FILES else ""
                pattern = "|".join(f'"{command.name} {name}"' for name in option.names)
                reply = f'COMPREPLY=($(compgen {kind} -- "$word")); ' if kind else "COMPREPLY=(); "
                values += f"    {pattern}) {reply}return ;;\n"
        words, files = operands(command)
        names = " ".join(name for option in command.options for name in option.names)
        options += (f'    {command.name}) words="{names}" operands="{" ".join(words)}" '
                    f'files={"yes" if files else ""} ;;\n')
    return BASH.replace("@VALUES@", values).replace("@OPTIONS@", options).replace(
        "@COMMANDS@", " ".join(c.name for c in program.commands))


def zsh_quoted(text):
    return text.replace("'", "'\\''").replace("[", "\\[").replace("]", "\\]").replace(":", "\\:")


def zsh_option(option):
    action = f"({' '.join(option.choices)})" if option.choices else "_files" if option.value in FILES else ""
    value = f":{zsh_quoted(option.value)}:{action}" if option.value else ""
    repeated = "*" if "repeatable" in option.meaning else ""
    names = option.names
    lines = [f"'{repeated}{name}[{zsh_quoted(option.meaning)}]{value}'" for name in names]
    if len(names) > 1 and not repeated:
        lines = [f"'({' '.join(names)})" + line[1:] for line in lines]
    return lines


def zsh(program):
    text = ["#compdef kovacic", "# zsh completion, made from --help by tools/packaging/completion.py", "",
            "_kovacic() {", "  local -a commands=("]
    text += [f"    '{c.name}:{zsh_quoted(c.summary)}'" for c in program.commands]
    text += ["  )", "  local context state line", "  typeset -A opt_args",
             "  _arguments -C '(- *)--help[Print this help message and exit]' '(- *)--version[the version of kovacic and of its libraries]' \\",
             "    '1:command:->command' '*::argument:->argument' && return", "  case $state in",
             "    command) _describe command commands ;;", "    argument)", "      case $words[1] in"]
    for command in program.commands:
        words, files = operands(command)
        lines = [line for option in command.options for line in zsh_option(option)]
        if words or files:
            lines.append(f"'*:{'file' if files else 'word'}:{'_files' if files else '(' + ' '.join(words) + ')'}'")
        body = " \\\n            ".join(lines)
        text.append(f"        {command.name})\n          _arguments \\\n            {body} ;;")
    text += ["      esac ;;", "  esac", "}", "", '_kovacic "$@"', ""]
    return "\n".join(text)


def main():
    program, shell = Program(sys.argv[1]), sys.argv[2]
    print({"bash": bash, "zsh": zsh}[shell](program), end="")


if __name__ == "__main__":
    main()
