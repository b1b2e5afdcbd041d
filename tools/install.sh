#!/bin/sh
# install.sh install|uninstall: what `make install` and `make uninstall` do, after the release build.
# PREFIX (/usr/local) is where the program will lie, DESTDIR what stands before that while it is put
# there; ZSH_FOLDER is the folder for zsh's completions below PREFIX.
set -eu
cd "$(dirname "$0")/.."
prefix=${DESTDIR:-}${PREFIX:-/usr/local}
zsh=$prefix/${ZSH_FOLDER:-share/zsh/site-functions}
share=$prefix/share/project

if [ "$1" = uninstall ]; then
    rm -rf "$share" "$prefix/lib/project"
    rm -f "$prefix/bin/Project" "$prefix/share/man/man1/Project.1" "$zsh/_Project" \
        "$prefix/share/bash-completion/completions/Project"
    exit
fi

# printed WHAT FILE: a text that the program makes itself.
printed() {
    mkdir -p "$(dirname "$2")"
    ./Project --print "$1" > "$2"
    chmod 644 "$2"
}

install -d "$prefix/bin" "$prefix/lib/project" "$share"
install -s -m 755 Project "$prefix/bin/Project"
install -s -m 644 build/release/librt_oiio.so build/release/librt_preview.so "$prefix/lib/project"
printed man "$prefix/share/man/man1/Project.1"
printed bash-completion "$prefix/share/bash-completion/completions/Project"
printed zsh-completion "$zsh/_Project"
printed stubs "$share/stubs/gr.lua"
# Links between the documentation, the scenes and their meshes and images stay what they are.
tar -c --exclude=__pycache__ README.md Documentation scenes Assets project.lua tools/slurm_array.sh | tar -x --no-same-owner -C "$share"
chmod -R u=rwX,go=rX "$share"
