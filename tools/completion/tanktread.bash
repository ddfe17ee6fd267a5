# Completion of tanktread in bash: the program itself tells what may stand where the cursor is.
_tanktread()
{
    local cur words cword kind answer
    _get_comp_words_by_ref -n =: cur words cword
    mapfile -t answer < <("${1/#\~/$HOME}" complete -- "${words[@]:1:cword}" 2>/dev/null)
    kind=${answer[0]-}
    [[ $cur == --*=* && $kind != words ]] && cur=${cur#*=}
    case $kind in
        files) _filedir toml ;;
        any_files) _filedir ;;
        directories) _filedir -d ;;
        words)
            COMPREPLY=("${answer[@]:1}")
            COMPREPLY=("${COMPREPLY[@]%%$'\t'*}")
            [[ ${COMPREPLY-} == *= ]] && compopt -o nospace
            # bash takes what follows "=" for a word of its own
            [[ $cur == *=* && $COMP_WORDBREAKS == *=* ]] && COMPREPLY=("${COMPREPLY[@]#"${cur%"${cur##*=}"}"}")
            ;;
    esac
} && complete -F _tanktread tanktread
