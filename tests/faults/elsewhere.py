"""Cases that another suite holds, by file and a part of the test's name; and those of features that there are not."""

ELSEWHERE = {}
ABSENT = {
    "A12": "--shard",
    "B11": "--watch",
    "G12": ".tx files: textures are read as they are",
    "G14": "{colorspace=}: what an image is used as says how it is read",
    "I17": "NFS and FUSE",
    "J6": "a snapshot on SIGUSR1",
    "K1": "checkpoints", "K2": "checkpoints", "K3": "checkpoints", "K4": "shards", "K5": "shards",
    "K9": "checkpoints", "K11": "--preview", "K12": "tev",
}
