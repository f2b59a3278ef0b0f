#!/usr/bin/env -S zsh -f
# zsh_candidates.zsh FOLDER LINE: the words that zsh offers at the end of a command line, one a line,
# with the completion functions in a folder. A second zsh, on a terminal of its own, is asked by Tab.
zmodload zsh/zpty
zpty shell "PS1= zsh -f -i"
zpty -w shell "fpath=(${(q)1} \$fpath); autoload -Uz compinit; compinit -D -u"

# Each call of compadd that is not about arrays of its caller notes what it adds.
zpty -w shell 'compadd() {
    local -a found; local -i end=${@[(i)(-|--)]}
    [[ ${@[1,end-1]} == *-[a-zA-Z]#[OAD]* ]] || { builtin compadd -A found "$@"; candidates+=($found) }
    builtin compadd "$@"
}'
zpty -w shell 'list() { candidates=(); zle complete-word; print -rl "<<" $candidates ">>"; exit }'
zpty -w shell 'zle -N list; bindkey "^I" list; echo read""y'
zpty -r shell text '*ready*'
zpty -w -n shell "$2"$'\t'
zpty -r shell text '*>>*'
text=${${text##*<<}%%>>*}
print -rl -- ${(f)text//$'\r'}
