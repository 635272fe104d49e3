#!/usr/bin/env python3
"""A long synthesis in shares: on the processes of this machine, or on many machines by Ray.

    python3 scripts/shares.py --shares 12 --folder parts -- --ratios '…' --sets 4 --elements 5
    python3 scripts/shares.py --ray auto --shares 200 --folder /shared/parts -- --ratios '…' --sets 5 --elements 6
    python3 scripts/shares.py --prove

What stands after `--` are the options of `epicyclic synthesize`. Each share is a task: it runs `epicyclic synthesize … --shard i/n` and
leaves `part-i-of-n.parquet` in the folder, which all machines see under one name. A share that dies is done again, from the last
`.progress` it kept; one that is complete already is not done again, so the same call goes on after any interruption. When all parts are
there, they are merged into `answer.json`, and DuckDB counts what each share found.

`--prove` shows it on a local cluster of two nodes, each with one processor: when the first share is complete, one node is killed with
what runs on it. The answer is compared with that of one search in one process, byte for byte.

Needs Python 3.11 and, for Ray and DuckDB, `pip install ray duckdb`. The program is found as `--program` or built with cargo. Not
part of the gate.
"""

import argparse
import concurrent.futures
import ctypes
import logging
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent

# An eight-speed automatic: 122 400 structures, each with all sets of five shift elements.
QUESTION = [
    "--ratios", "4.7143, 3.1429, 2.1064, 1.6667, 1.2854, 1, 0.8387, 0.6667, -3.2952",
    "--sets", "3..4", "--elements", "5", "--engaged", "3",
]


def part(folder, share, shares):
    """The file of a share."""
    return pathlib.Path(folder) / f"part-{share}-of-{shares}.parquet"


def dies_with_its_parent():
    """A search whose worker is killed ends, too, so that no two write one part (Linux)."""
    pr_set_pdeathsig = 1
    ctypes.CDLL(None).prctl(pr_set_pdeathsig, signal.SIGKILL)


def search(program, question, folder, share, shares, threads):
    """Searches a share to its end; the answer is what the program told last, and how long it took."""
    begun = time.monotonic()
    line = [program, "synthesize", *question, "--shard", f"{share}/{shares}", "-o", str(part(folder, share, shares))]
    done = subprocess.run(
        line,
        env={**os.environ, "RAYON_NUM_THREADS": str(threads)},
        preexec_fn=dies_with_its_parent,
        capture_output=True,
        text=True,
    )
    told = done.stderr.strip().splitlines()
    return share, done.returncode, told[-1] if told else "", time.monotonic() - begun


def tell(found, done, shares):
    """Tells of a share that ended. What one refuses, all refuse: then everything ends."""
    share, code, told, took = found
    if code != 0:
        sys.exit(f"share {share} of {shares}: {told}")
    # note: FILE is complete: share 1/3, 67 structures searched, 0 gearboxes found
    print(f"{done:4} of {shares}: {told.rpartition(': ')[2]}; {took:.1f} s", flush=True)


def by_processes(program, question, folder, shares):
    """All shares by as many processes as there are processors."""
    at_once = min(os.cpu_count() or 1, shares)
    # The threads of the pool only wait for their processes.
    with concurrent.futures.ThreadPoolExecutor(at_once) as pool:
        tasks = [pool.submit(search, program, question, folder, share, shares, 1) for share in range(1, shares + 1)]
        try:
            for done, task in enumerate(concurrent.futures.as_completed(tasks), 1):
                tell(task.result(), done, shares)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


def by_ray(program, question, folder, shares, after_first=None):
    """All shares as tasks of a cluster, one processor each. A task whose node dies is begun again elsewhere."""
    import ray

    # What is refused is refused everywhere: only what dies is tried again.
    task = ray.remote(num_cpus=1, max_retries=-1)(search)
    pending = [task.remote(program, question, str(folder), share, shares, 1) for share in range(1, shares + 1)]
    done = 0
    while pending:
        ready, pending = ray.wait(pending)
        for found in ray.get(ready):
            done += 1
            tell(found, done, shares)
            if done == 1 and after_first:
                after_first()


def merged(program, question, folder, shares):
    """The answer from all parts."""
    parts = [str(part(folder, share, shares)) for share in range(1, shares + 1)]
    answer = pathlib.Path(folder) / "answer.json"
    done = subprocess.run([program, "synthesize", *question, "--merge", *parts, "--format", "json", "-o", str(answer)])
    if done.returncode != 0:
        # The program has said why: no gearbox has these ratios, for instance.
        sys.exit(done.returncode)
    return answer


def table_of_parts(folder, shares):
    """What each part holds, by a query over all of them."""
    try:
        import duckdb
    except ImportError:
        print("without DuckDB no table of the parts: pip install duckdb")
        return
    files = str(pathlib.Path(folder) / f"part-*-of-{shares}.parquet")
    query = """
        SELECT parse_filename(filename, true) AS part, count(*) AS gearboxes, count(DISTINCT structure) AS structures
        FROM read_parquet(?, filename = true) GROUP BY ALL ORDER BY part"""
    for name, gearboxes, structures in duckdb.execute(query, [files]).fetchall():
        print(f"{name}: {gearboxes} gearboxes of {structures} structures")


def prove(program, folder, shares):
    """Two nodes, of which one is killed, against one search."""
    import ray
    from ray.cluster_utils import Cluster

    # That a node dies is no news here.
    logging.getLogger("ray").setLevel(logging.CRITICAL)
    cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1})
    other = cluster.add_node(num_cpus=1)
    ray.init(address=cluster.address, log_to_driver=False, logging_level=logging.CRITICAL)

    def kill():
        cluster.remove_node(other, allow_graceful=False)
        print("one of the two nodes is killed", flush=True)

    by_ray(program, QUESTION, folder, shares, kill)
    ray.shutdown()
    cluster.shutdown()
    answer = merged(program, QUESTION, folder, shares).read_bytes()
    table_of_parts(folder, shares)
    whole = pathlib.Path(folder) / "whole.json"
    subprocess.run([program, "synthesize", *QUESTION, "--format", "json", "-o", str(whole)], check=True, capture_output=True)
    if whole.read_bytes() != answer:
        sys.exit("the answers differ")
    print(f"{len(answer)} bytes, the same as those of one search")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shares", type=int, default=12, help="into how many shares the search is divided (12)")
    parser.add_argument("--folder", type=pathlib.Path, help="folder for the parts, which all machines see (a new one)")
    parser.add_argument("--ray", metavar="ADDRESS", help="address of a cluster, or auto; else processes of this machine")
    parser.add_argument("--program", help="the program, which all machines see under one name (built here)")
    parser.add_argument("--prove", action="store_true", help="shows it on a local cluster of two nodes")
    parser.add_argument("question", nargs="*", help="after --: options of synthesize")
    args = parser.parse_args()
    if args.prove == bool(args.question):
        parser.error("a question is due after --, or --prove, which has its own")
    if args.shares < 1:
        parser.error(f"--shares {args.shares}: at least 1")
    program = args.program
    if not program:
        subprocess.run(["cargo", "build", "--quiet", "--release", "--package", "epicyclic"], cwd=ROOT, check=True)
        target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
        program = str((target / "release" / "epicyclic").resolve())
    elif not shutil.which(program):
        parser.error(f"--program {program}: cannot be run")
    folder = args.folder or pathlib.Path(tempfile.mkdtemp(prefix="epicyclic-shares-"))
    folder.mkdir(parents=True, exist_ok=True)
    print(f"parts in {folder}", flush=True)
    if args.prove:
        prove(program, folder, args.shares)
        return
    if args.ray:
        import ray

        ray.init(address=args.ray, log_to_driver=False)
        by_ray(program, args.question, folder, args.shares)
    else:
        by_processes(program, args.question, folder, args.shares)
    table_of_parts(folder, args.shares)
    print(f"the answer is {merged(program, args.question, folder, args.shares)}")


if __name__ == "__main__":
    main()
