#!/usr/bin/env python3
"""make_room_assets.py [NAME ...]: writes the models, textures and bump maps of scenes/room.lua (Assets/*/room_*).

With names, only the makers of those names (functions of tools/room_assets/). Python's standard library is enough;
everything is computed from integer hashes and formulas, so the same files result on every run. About two minutes
of processor time.
"""
import multiprocessing, os, sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "room_assets"))
import cat, models, paintings, textures  # noqa: E402

MAKERS = {maker.__name__: maker for part in (paintings, textures, models, cat) for maker in part.ALL}


def make(name):
    MAKERS[name]()


def main():
    wanted = sys.argv[1:] or list(MAKERS)
    unknown = [name for name in wanted if name not in MAKERS]
    if unknown:
        sys.exit("make_room_assets.py: no maker %s; there are %s" % (", ".join(unknown), ", ".join(MAKERS)))
    with multiprocessing.Pool() as pool:
        pool.map(make, wanted, 1)


if __name__ == "__main__":
    main()
