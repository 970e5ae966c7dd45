#!/usr/bin/env python3
"""What threads gain on a scene whose bodies do not read each other: 1000 pendulums (S3), by the clock on the wall and by
the processor's time, beside what the division of the work allows.

usage: threads.py PATH-TO-ASGARD [--threads 1,2,4] [--pendulums 1000] [--ratio 1] [--seconds 100] [--runs 5] [--smoke]

Rows of CSV: threads, wall seconds, processor seconds (the least of the runs, each with its reading), how many times as
fast, how many times as fast it could be (all evaluations over those of the thread that has most, when pieces are given
out one by one), and whether the motion and all counts are those of one thread. Only idle cores say what threads gain.
"""
import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time

# S3: every pendulum by itself; the first is as many times as fast as the others as `ratio` says.
def scene(pendulums, seconds, ratio):
    lines = [f"simulator -finish {seconds} -collisions 0", "shape_set ball -desc {-sub {-sphere 0.1}}"]
    for n in range(pendulums):
        lines += [f"body b{n} ball -init_pos {{{0.5 + n / max(1, pendulums - 1)} 0 {n}}}",
                  f"force -body b{n} -x {{-{10 * ratio ** 2 if n == 0 else 10} * b{n}.mass * sin(b{n}.x)}}"]
    return "\n".join(lines) + "\n"


def run(asgard, path, threads, folder):
    stats, table = os.path.join(folder, "stats.json"), os.path.join(folder, "table.csv")
    used, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run([asgard, "simulate", path, "--threads", str(threads), "--csv", table, "--at", "0:1:2", "--stats", stats],
                   check=True)
    wall, now = time.monotonic() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(stats, encoding="utf-8") as file:
        told = json.load(file)
    with open(table, encoding="utf-8") as file:
        motion = file.read()
    cpu = now.ru_utime + now.ru_stime - used.ru_utime - used.ru_stime
    return wall, cpu, {k: v for k, v in told.items() if not k.startswith("seconds")}, motion


# Who is free takes the next pieces: pendulums in their order, as the engine gives them out.
def possible(told, threads):
    pendulums = [c["evaluations"] for c in told["component_list"] if c["steps"] > 0]
    together = 1 + len(pendulums) // (16 * threads)
    load = [0] * threads
    for i in range(0, len(pendulums), together):
        load[load.index(min(load))] += sum(pendulums[i:i + together])
    return sum(load) / max(load)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("asgard")
    parser.add_argument("--threads", default="1,2,4")
    parser.add_argument("--pendulums", type=int, default=1000)
    parser.add_argument("--seconds", type=float, default=100)
    parser.add_argument("--ratio", type=float, default=1)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--smoke", action="store_true", help="for a moment, to see that it works")
    a = parser.parse_args()
    if a.smoke:
        a.pendulums, a.seconds, a.runs = 100, 5, 1
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "s3.al")
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene(a.pendulums, a.seconds, a.ratio))
        print("threads,wall,cpu,faster,possible,same")
        first = None
        for threads in map(int, a.threads.split(",")):
            runs = [run(a.asgard, path, threads, folder) for _ in range(a.runs)]
            wall, cpu, told, motion = min(r[0] for r in runs), min(r[1] for r in runs), runs[0][2], runs[0][3]
            first = first or (wall, told, motion)
            same = all((r[2], r[3]) == first[1:] for r in runs)
            print(f"{threads},{wall:.4g},{cpu:.4g},{first[0] / wall:.3g},{possible(told, threads):.3g},"
                  f"{'yes' if same else 'NO'}", flush=True)
            if not same:
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
