"""For each source: a key of what clang-tidy would read of ours, and the source. Usage: tidy_keys.py SOURCE...

The key covers the source, the headers of this project that it includes (by the quoted includes as written), the
settings of clang-tidy, the list of packages and the compiler's options.
"""
import hashlib, os, re, sys

INCLUDE = re.compile(rb'^\s*#\s*include\s+"([^"]+)"', re.M)
ROOTS = ["common", "host", "medium-asgard", "medium-asgard/engine", "."]
read = {}


def contents(path):
    if path not in read:
        with open(path, "rb") as file:
            read[path] = file.read()
    return read[path]


def headers(path, seen):
    for name in INCLUDE.findall(contents(path)):
        for root in [os.path.dirname(path), *ROOTS]:
            found = os.path.normpath(os.path.join(root, name.decode()))
            if os.path.isfile(found):
                if found not in seen:
                    seen.add(found)
                    headers(found, seen)
                break


settings = b"".join(contents(f) for f in (".clang-tidy", "packaging/packages.txt", "cmake/compiler.cmake"))
for source in sys.argv[1:]:
    seen = {source}
    headers(source, seen)
    digest = hashlib.sha256(settings)
    for path in sorted(seen):
        digest.update(path.encode() + b"\0" + contents(path))
    print(digest.hexdigest(), source)
