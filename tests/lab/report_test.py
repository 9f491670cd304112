#!/usr/bin/env python3
"""The documents of tools/lab/report say what the results say, the bad too: made from made-up results with --from."""
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]

ABOUT = {"date": "2026-01-31", "commit": "abc1234", "cpu": "Some Processor", "cores": 2, "system": "Debian", "compiler": "c++ 12",
         "build_type": "Release", "peers": ["Box2D 2.4.1"], "noise": "It was quiet.", "commands": {"accuracy": "cairn-lab accuracy"}}


def summary(metric, engine, error, same_time, ratio):
    return {"summary": metric, "engine": engine, "error_unit": "of it", "compared": True, "error": error, "cpu_s_per_sim_s": 2e-5,
            "order": None, "cpu_s_to_1_percent": 1e-5, "cpu_s_to_01_percent": None, "error_in_same_time": same_time, "ratio": ratio}


def case(number, engine, passed, broken=()):
    return {"case": number, "name": "tower", "engine": engine, "passed": passed, "figures": {name: 0.25 for name in broken},
            "limits": {name: 0.1 for name in broken}, "broken": list(broken), "cpu_ms": 3.0}


def scene(engine, ms, ratio):
    return {"scene": "heap", "engine": engine, "steps": 11, "bodies": 1000, "contacts": 5, "touching": 4, "joints": 0, "ms_total": ms,
            "ms_per_step": {"min": 1, "median": 2, "p99": 3}, "ratio": ratio, "awake_body_steps": 1, "max_penetration_m": 0.002,
            "jitter_m_s": 1e-3}


def counted(feature, bodies, full, without):
    return {"check": "instructions", "feature": feature, "bodies": bodies, "full": full, "without": without,
            "difference": full / without - 1, "bytes_difference": 0, "same_state_and_allocations": True, "passed": True}


RESULTS = {
    "accuracy": [{"problem": "fall/height", "engine": "cairn", "error": 1e-3, "failed": False},
                 summary("fall/height", "cairn", 1e-3, 1e-3, 1), summary("fall/height", "box2d", 0.5, 0.25, 250),
                 summary("swing/period", "cairn", 0.125, 0.125, 1), summary("swing/period", "box2d", 0.5, 0.0625, 0.5)],
    "torture": [case("1", "cairn", True), case("1", "box2d", False, ["drop_m"]), case("2", "cairn", False, ["lean_m"]),
                case("2", "box2d", True)],
    "determinism": [{"scene": "heap", "threads": 2, "simd": "avx2", "steps": 10, "bodies": 9, "hash": "0", "same": False,
                     "first_step": 7, "first_body": 4, "what": "x: 1 and 2"}],
    "cost": [counted("joints", 100, 1001, 1000), counted("joints", 1000, 10001, 10000),
             {"check": "slope", "feature": "joints", "full": 10, "without": 10, "difference": 0, "passed": True},
             {"check": "refusal", "feature": "joints", "said": "joints were left out", "passed": True},
             {"check": "calls", "feature": "joints", "functions": 7, "called": ["f"], "entrances_called": 2, "passed": False},
             {"check": "added", "what": "sensor", "bodies": 1000, "instructions": 500, "most": 900, "passed": True},
             {"check": "empty_world", "bytes": 14000, "most": 16384, "passed": True},
             {"check": "bytes_per_body", "bytes": 1234.0, "passed": True}],
    "compare": [scene("cairn", 20, 1), scene("box2d", 10, 0.5)],
}

# What each document must say; none of it is there word for word in the results.
SENTENCES = {
    "accuracy": ["in 1 of 2 metrics", "- `swing/period`: Cairn 1.25e-01; box2d 6.25e-02 in the same time", "Some Processor, 2 cores",
                 "| [fall/height](#fall) | 1.0e-03 | 20 | - | 10 | never | 5.0e-01 | 2.5e-01 | 2.5e+02 |", "cairn-lab accuracy",
                 "![swing/period](images/accuracy/swing_period.svg)"],
    "stability": ["- cairn: 1 of 2 cases hold", "A peer holds where Cairn does not: cases 2.", "**lean_m 0.25 (0.1)**",
                  "first after step 7, body 4, x: 1 and 2"],
    "cost": ["1 of 8 limits do not hold", "Instructions per step differ by 0.100% at most (joints, 100 bodies)",
             "1 of 7 functions of features", "| sensor | 500 | 5.00% | 900 |", "- joints were left out"],
    "performance": ["it is faster in `heap`", "| heap | cairn | 2.000 | 1.00 | 1,000 | 4 | 2.00 | 1.0e-03 |"],
}


def main():
    with tempfile.TemporaryDirectory() as folder:
        source, to = pathlib.Path(folder) / "results", pathlib.Path(folder) / "docs"
        source.mkdir()
        (source / "about.json").write_text(json.dumps(ABOUT))
        for name, lines in RESULTS.items():
            (source / f"{name}.json").write_text("".join(json.dumps(line) + "\n" for line in lines))
        subprocess.run([ROOT / "tools/lab/report", "--from", source, "--to", to], check=True, stdout=subprocess.DEVNULL)
        missing = [f"{name}.md does not say: {sentence}" for name, sentences in SENTENCES.items() for sentence in sentences
                   if " ".join(sentence.split()) not in " ".join((to / f"{name}.md").read_text().split())]
        for image in ("cost/instructions.svg", "performance/scenes.svg"):
            if not (to / "images" / image).read_text().startswith("<svg "):
                missing.append(f"{image} is no picture")
        refused = subprocess.run([ROOT / "tools/lab/report", "--from", to], capture_output=True, text=True)
        if refused.returncode == 0 or "there are no results" not in refused.stderr:
            missing.append("a folder without results is not refused")
    print("\n".join(missing) or "the documents say what the results say")
    return 1 if missing else 0


sys.exit(main())
