"""Cases that another suite holds, by file and a part of the test's name; and those of features that there are not."""

ELSEWHERE = {
    "B11": ("tests/end_to_end/writing_scenes.py", "an_editor_that_empties_the_file_first"),
    "G6": ("tests/image/image_test.cpp", "what is no colour becomes 0"),
    "G10": ("tests/image/image_faults_test.cpp", "without OpenImageIO the message says what to install"),
    "J10": ("tests/core/parallel_test.cpp", "an exception in a worker comes back to the caller"),
    "J12": ("tools/test.sh", "rendering, thread-sanitized"),
    "K6": ("tests/app/compare_test.cpp", "Sizes that differ, missing files and damaged ones are failed comparisons"),
    "K7": ("tests/golden/planted_faults.py", "portable"),
    "K8": ("tests/app/compare_test.cpp", "Values that are not finite never pass"),
    "K11": ("tests/end_to_end/writing_scenes.py", "strangers_are_refused"),
    "K10": ("tests/app/output_names_test.cpp", "two frames never share a file"),
}
ABSENT = {
    "G12": ".tx files are no images that are read",
    "G14": "{colorspace=}: what an image is used for says how it is read",
    "H11": "plugins that change the floating-point environment: the only one loaded is OpenImageIO",
    "H13": "--time within a pixel, and a heat map",
    "I17": "file systems without renames: one file that cannot be renamed over is overwritten in place",
    "K12": "sending images to tev: --preview shows what it would",
}
