#!/usr/bin/env python3
"""A long synthesis in shares, or the sizes of many gearboxes: on the processes of this machine, or on many machines by Ray.

    python3 scripts/shares.py --shares 12 --folder parts -- --ratios '…' --sets 4 --elements 5
    python3 scripts/shares.py --ray auto --shares 200 --folder /shared/parts -- --ratios '…' --sets 5 --elements 6
    python3 scripts/shares.py --folder sizes --size boxes/*.yaml -- --width-ratio 1
    python3 scripts/shares.py --prove

What stands after `--` are the options of `epicyclic synthesize`. Each share is a task: it runs `epicyclic synthesize … --shard i/n` and
leaves `part-i-of-n.parquet` in the folder, which all machines see under one name. A share that dies is done again, from the last
`.progress` it kept; one that is complete already is not done again, so the same call goes on after any interruption. When all parts are
there, they are merged into `answer.json`, and DuckDB counts what each share found.

With `--size` each gearbox is a task: `epicyclic size FILE …` leaves its answer in the folder, under the name of the file and a mark of
what is in it, the options and the program. So what is there already is not done again, and what was changed is. DuckDB puts the best
design of each set into `sizes.parquet`. A gearbox that is refused, or that no size holds, is told at the end and keeps none of the others
out; the exit code is then 1.

`--prove` shows it on a local cluster of two nodes, each with one processor: when the first share is complete, one node is killed with
what runs on it. The answer is compared with that of one search in one process, byte for byte.

Needs Python 3.11 and, for Ray and DuckDB, `pip install ray duckdb`. The program is found as `--program` or built with cargo. Not
part of the gate.
"""

import argparse
import concurrent.futures
import ctypes
import hashlib
import json
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


def run(line):
    """A command of the program on one thread: its exit code, what it told, how long it took."""
    begun = time.monotonic()
    environment = {**os.environ, "RAYON_NUM_THREADS": "1"}
    done = subprocess.run(line, env=environment, preexec_fn=dies_with_its_parent, capture_output=True, text=True)
    return done.returncode, done.stderr.strip(), time.monotonic() - begun


def search(program, question, folder, share, shares):
    """Searches a share to its end; the answer is what the program told last, and how long it took."""
    line = [program, "synthesize", *question, "--shard", f"{share}/{shares}", "-o", str(part(folder, share, shares))]
    code, told, took = run(line)
    return share, code, told.splitlines()[-1] if told else "", took


def tell(found, done, shares):
    """Tells of a share that ended. What one refuses, all refuse: then everything ends."""
    share, code, told, took = found
    if code != 0:
        sys.exit(f"share {share} of {shares}: {told}")
    # note: FILE is complete: share 1/3, 67 structures searched, 0 gearboxes found
    print(f"{done:4} of {shares}: {told.rpartition(': ')[2]}; {took:.1f} s", flush=True)


def size(program, options, file, answer):
    """The sizes of a gearbox; the answer is why there are none, if so, and how long it took, if it was not there already."""
    if os.path.exists(answer):
        return file, why_none(file, answer), None
    _, told, took = run([program, "size", file, *options, "--format", "json", "-o", answer])
    return file, why_none(file, answer) if os.path.exists(answer) else told.removeprefix("error: "), took


def why_none(file, answer):
    """What an answer says of a gearbox of which a set has no sizes."""
    has_all = json.loads(pathlib.Path(answer).read_text())["mass_kg"] is not None
    return "" if has_all else f"{file}: no design of the space holds; {answer} tells what leaves them out"


def answers_of(program, options, files, folder):
    """The files of the answers: others for other gearboxes, other options and another program."""
    common = hashlib.sha256()
    for word in options:
        common.update(word.encode() + b"\0")
    # A table of bearings is an option with a file.
    for name in [*filter(os.path.isfile, options), program]:
        common.update(pathlib.Path(name).read_bytes())
    answers = []
    for file in files:
        mark = common.copy()
        # What cannot be read is refused by the program.
        if file.is_file():
            mark.update(file.read_bytes())
        answers.append(folder / f"{file.stem}-{mark.hexdigest()[:16]}.json")
    return answers


def by_processes(task, calls):
    """Tasks by as many processes as there are processors, as they end."""
    # The threads of the pool only wait for their processes.
    with concurrent.futures.ThreadPoolExecutor(min(os.cpu_count() or 1, len(calls))) as pool:
        pending = [pool.submit(task, *call) for call in calls]
        try:
            for done in concurrent.futures.as_completed(pending):
                yield done.result()
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


def by_ray(task, calls):
    """Tasks of a cluster, one processor each, as they end. A task whose node dies is begun again elsewhere."""
    import ray

    # What is refused is refused everywhere: only what dies is tried again.
    remote = ray.remote(num_cpus=1, max_retries=-1)(task)
    pending = [remote.remote(*call) for call in calls]
    while pending:
        ready, pending = ray.wait(pending)
        yield from ray.get(ready)


def searches(program, question, folder, shares):
    """The calls of `search`."""
    return [(program, question, str(folder), share, shares) for share in range(1, shares + 1)]


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


def sized(program, options, files, folder, at_work):
    """All gearboxes; whether each has its sizes."""
    without = []
    answers = answers_of(program, options, files, folder)
    calls = [(program, options, str(file), str(answer)) for file, answer in zip(files, answers)]
    for done, (file, why, took) in enumerate(at_work(size, calls), 1):
        if why:
            without.append(why)
        how = "there already" if took is None else f"{took:.1f} s"
        print(f"{done:4} of {len(files)}: {file}; {how}", flush=True)
    table_of_sizes([str(answer) for answer in answers if answer.exists()], folder)
    sys.stdout.flush()
    for why in sorted(without):
        print(why, file=sys.stderr)
    return not without


def table_of_sizes(answers, folder):
    """The best design of each set of all gearboxes as Parquet, and their masses."""
    try:
        import duckdb
    except ImportError:
        print("without DuckDB no table of the sizes: pip install duckdb")
        return
    if not answers:
        return
    table = pathlib.Path(folder) / "sizes.parquet"
    query = """
        SELECT answer, gearbox, mass_kg AS gearbox_mass_kg, of_set.set AS set, unnest(of_set.found[1]) FROM (
            SELECT parse_filename(filename) AS answer, gearbox, mass_kg, unnest(sets) AS of_set
            FROM read_json($files, filename = true, union_by_name = true, sample_size = -1, maximum_object_size = 1000000000)
        ) ORDER BY answer, set"""
    duckdb.execute(f"CREATE TABLE best AS {query}", {"files": answers})
    # Whole or not at all.
    half = table.with_suffix(".part")
    duckdb.execute(f"COPY best TO '{half}' (FORMAT parquet)")
    os.replace(half, table)
    print(f"the best designs of {len(answers)} gearboxes are in {table}")


def prove(program, folder, shares):
    """Two nodes, of which one is killed, against one search."""
    import ray
    from ray.cluster_utils import Cluster

    # That a node dies is no news here.
    logging.getLogger("ray").setLevel(logging.CRITICAL)
    cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1})
    other = cluster.add_node(num_cpus=1)
    ray.init(address=cluster.address, log_to_driver=False, logging_level=logging.CRITICAL)

    for done, found in enumerate(by_ray(search, searches(program, QUESTION, folder, shares)), 1):
        tell(found, done, shares)
        if done == 1:
            cluster.remove_node(other, allow_graceful=False)
            print("one of the two nodes is killed", flush=True)
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
    parser.add_argument("--size", metavar="FILE", type=pathlib.Path, nargs="+", help="gearboxes whose sizes are sought")
    parser.add_argument("--prove", action="store_true", help="shows it on a local cluster of two nodes")
    parser.add_argument("question", nargs="*", help="after --: options of synthesize, or of size")
    args = parser.parse_args()
    if args.prove and (args.question or args.size):
        parser.error("--prove has its own question")
    if not (args.prove or args.size or args.question):
        parser.error("a question is due after --, or --size with gearboxes, or --prove")
    if args.shares < 1:
        parser.error(f"--shares {args.shares}: at least 1")
    program = args.program
    if not program:
        subprocess.run(["cargo", "build", "--quiet", "--release", "--package", "epicyclic"], cwd=ROOT, check=True)
        target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
        program = str((target / "release" / "epicyclic").resolve())
    elif not (program := shutil.which(program)):
        parser.error(f"--program {args.program}: cannot be run")
    folder = args.folder or pathlib.Path(tempfile.mkdtemp(prefix="epicyclic-shares-"))
    folder.mkdir(parents=True, exist_ok=True)
    print(f"{'answers' if args.size else 'parts'} in {folder}", flush=True)
    if args.prove:
        prove(program, folder, args.shares)
        return
    at_work = by_processes
    if args.ray:
        import ray

        ray.init(address=args.ray, log_to_driver=False)
        at_work = by_ray
    if args.size:
        sys.exit(0 if sized(program, args.question, args.size, folder, at_work) else 1)
    for done, found in enumerate(at_work(search, searches(program, args.question, folder, args.shares)), 1):
        tell(found, done, args.shares)
    table_of_parts(folder, args.shares)
    print(f"the answer is {merged(program, args.question, folder, args.shares)}")


if __name__ == "__main__":
    main()
