"""What the programs said, as documents: docs/accuracy.md, stability.md, cost.md and performance.md.

Every figure comes from the lines of JSON in the folder of results; nothing is typed in. Where a peer does better, the
document says so in words, before the table.
"""
import json
import textwrap

import charts

CAIRN = "cairn"


class Results:
    """The folder with the results: NAME.json, one object a line, and about.json."""

    def __init__(self, folder):
        self.folder = folder
        self.about = json.loads((folder / "about.json").read_text())

    def lines(self, name):
        path = self.folder / f"{name}.json"
        return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []

    def has(self, *names):
        return all((self.folder / f"{name}.json").exists() for name in names)

    def head(self, title, introduction, *names):
        """The title, what it is about, the machine, the commands."""
        about = self.about
        commands = "\n".join(about["commands"][name] for name in names if name in about["commands"])
        peers = ", ".join(about["peers"]) or "none"
        made = (f"Made by `tools/lab/report` on {about['date']} from commit {about['commit']}. Machine: {about['cpu']}, "
                f"{about['cores']} cores for this run, {about['system']}; compiler: {about['compiler']}, build type "
                f"{about['build_type']}. Peers: {peers}, as Debian packages them. {about['noise']}")
        return f"# {title}\n\n{paragraph(introduction)}{paragraph(made)}```\n{commands}\n```\n\n"


def paragraph(words):
    """As the documents written by hand are laid out."""
    return "\n".join(textwrap.wrap(" ".join(words.split()), 130, break_long_words=False, break_on_hyphens=False)) + "\n\n"


def table(heads, rows):
    """A table; the first column to the left, figures to the right."""
    lines = ["| " + " | ".join(heads) + " |", "|---|" + "---:|" * (len(heads) - 1)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n\n"


def engines_of(lines):
    return list(dict.fromkeys(line["engine"] for line in lines))


def shown(value, pattern="{:.3g}", scale=1.0, nothing="-"):
    return nothing if value is None else pattern.format(scale * value)


def ratio_text(value):
    """How many times better Cairn is."""
    if value is None:
        return "-"
    return f"{value:.2g}" if 0.01 <= value < 1000 else f"{value:.0e}".replace("e+0", "e").replace("e-0", "e-")


def listed(names):
    return ", ".join(f"`{name}`" for name in names)


# ---- docs/accuracy.md


def accuracy(results):
    lines = results.lines("accuracy")
    summaries = [line for line in lines if "summary" in line]
    engines = engines_of(summaries)
    peers = [engine for engine in engines if engine != CAIRN]
    rows_of = {}
    for line in summaries:
        rows_of.setdefault(line["summary"], {})[line["engine"]] = line

    def better_peers(row):
        return [peer for peer in peers if peer in row and row[peer]["ratio"] is not None and row[peer]["ratio"] < 1]

    compared = {name: row for name, row in rows_of.items() if row[CAIRN]["compared"] and len(row) > 1}
    worse = {name: better_peers(row) for name, row in compared.items() if better_peers(row)}
    words = results.head(
        "Accuracy",
        "The error of the simulation against the CPU time that it takes, for problems whose solution is known by a formula or "
        "by an integration in double precision. How it is measured, and what each metric is, is told in "
        "[tools/lab](../tools/lab/README.md#accuracy).", "accuracy")
    words += "## In short\n\n"
    words += paragraph(f"At its default setting Cairn is at least as accurate as each peer is within the same CPU time in "
                       f"{len(compared) - len(worse)} of {len(compared)} metrics; errors below 1e-6 count as equal.")
    if worse:
        words += "A peer does better here:\n\n"
        for name, who in worse.items():
            row = compared[name]
            words += f"- `{name}`: Cairn {shown(row[CAIRN]['error'], '{:.2e}', nothing='fails')}; " + "; ".join(
                f"{peer} {shown(row[peer]['error_in_same_time'], '{:.2e}')} in the same time" for peer in who) + "\n"
        words += "\n"
    words += "## All metrics\n\n" + paragraph("For Cairn at its default: the error, CPU microseconds per simulated second, the order p of error ~ "
              "dt^p, and the least time in which any setting gets to 1 % and 0.1 %. For a peer: its error at its default, the least "
              "error of all its settings that are as fast as Cairn's default, and how many times Cairn's error that is: above 1, "
              "Cairn is better.")
    heads = ["metric", "error", "us/s", "order", "us to 1 %", "to 0.1 %"]
    for peer in peers:
        heads += [peer, "same time", "ratio"]
    rows = []
    for name, row in rows_of.items():
        own = row[CAIRN]
        cells = [f"[{name}](#{name.split('/')[0]})", shown(own["error"], "{:.1e}", nothing="fails"),
                 shown(own["cpu_s_per_sim_s"], "{:.0f}", 1e6), shown(own["order"], "{:.1f}"),
                 shown(own["cpu_s_to_1_percent"], "{:.0f}", 1e6, "never"),
                 shown(own["cpu_s_to_01_percent"], "{:.0f}", 1e6, "never")]
        for peer in peers:
            other = row.get(peer)
            cells += ["", "", ""] if other is None else [
                shown(other["error"], "{:.1e}", nothing="fails"), shown(other["error_in_same_time"], "{:.1e}", nothing="none"),
                ratio_text(other["ratio"])]
        rows.append(cells)
    words += table(heads, rows)
    words += "## Plots\n\n" + paragraph("Error over CPU time per simulated second, both logarithmic: lower left is better. A line goes along the substeps "
              "(iterations, of the peers), a dashed one along the time steps; defaults have a ring, failures are crosses at the "
              "upper edge.")
    for problem in dict.fromkeys(name.split("/")[0] for name in rows_of):
        words += f"### {problem}\n\n"
        for name in rows_of:
            if name.split("/")[0] == problem:
                words += f"![{name}](images/accuracy/{name.replace('/', '_')}.svg)\n"
        words += "\n"
    return words, {}


# ---- docs/stability.md


def verdict(line):
    if line is None:
        return ""
    if line["passed"]:
        return "holds"
    if line.get("ended_by"):
        return "**ended** by " + line["ended_by"]
    broken = [f"{name} {shown(line['figures'].get(name), '{:.3g}', nothing='none')} ({shown(line['limits'].get(name), '{:.3g}')})"
              for name in line["broken"]]
    return "**" + "; ".join(broken[:2]) + ("; ..." if len(broken) > 2 else "") + "**"


def stability(results):
    lines = results.lines("torture")
    engines = engines_of(lines)
    cases = {}
    for line in lines:
        cases.setdefault(line["case"], {})[line["engine"]] = line
    words = results.head(
        "Stability",
        "Scenes that are hard on an engine, with what must hold in each: heavy on light, long chains, stiff springs, overlaps, "
        "numbers beyond measure. The cases, and what every one of them asks besides its own limits, are told in "
        "[tools/lab](../tools/lab/README.md#torture).", "torture", "determinism")
    words += "## In short\n\n"
    for engine in engines:
        own = [row[engine] for row in cases.values() if engine in row]
        words += f"- {engine}: {sum(line['passed'] for line in own)} of {len(own)} cases hold\n"
    failing = [number for number, row in cases.items() if not row[CAIRN]["passed"]]
    if failing:
        words += f"\nCairn does not yet hold in {len(failing)}: cases {', '.join(failing)}.\n"
    beaten = [number for number, row in cases.items() if not row[CAIRN]["passed"]
              and any(line["passed"] for engine, line in row.items() if engine != CAIRN)]
    if beaten:
        words += f"A peer holds where Cairn does not: cases {', '.join(beaten)}.\n"
    words += "\n## All cases\n\nA figure that does not hold is followed by its limit; CPU time is that of the steps, on one thread.\n\n"
    heads = ["case", "", *(cell for engine in engines for cell in (engine, "CPU ms"))]
    rows = []
    for number, row in cases.items():
        cells = [number, row[CAIRN]["name"]]
        for engine in engines:
            line = row.get(engine)
            cells += [verdict(line), "" if line is None else f"{line['cpu_ms']:.0f}"]
        rows.append(cells)
    words += table(heads, rows)

    proofs = results.lines("determinism")
    if proofs:
        scenes = dict.fromkeys(line["scene"] for line in proofs)
        settings = {(line["threads"], line["simd"]) for line in proofs}
        differing = [line for line in proofs if not line["same"]]
        words += ("## Determinism\n\n"
                  f"{len(scenes)} scenes, every kind of joint among them, were run with {len(settings) + 1} settings: up to "
                  f"{max(t for t, _ in settings)} threads, at the SIMD levels {', '.join(sorted({s for _, s in settings}))}. ")
        words += ("All of them went through the same states to the last bit, step by step.\n\n" if not differing else
                  "Not all of them went through the same states:\n\n" + "".join(
                      f"- {line['scene']}, {line['threads']} threads, {line['simd']}: first after step {line['first_step']}, "
                      f"body {line['first_body']}, {line['what']}\n" for line in differing) + "\n")
    return words, {}


# ---- docs/cost.md


def cost(results):
    lines = results.lines("cost")
    by_check = {}
    for line in lines:
        by_check.setdefault(line["check"], []).append(line)
    words = results.head(
        "Cost of what is not used",
        "A scene pays nothing for a feature that it does not use: its steps are counted, instruction by instruction, in the full build and "
        "in one from which the feature was left out ([ADR 014](adr/014-features.md)). How, is told in "
        "[tools/lab](../tools/lab/README.md#cost).", "cost")
    failed = [line for line in lines if not line["passed"]]
    words += "## In short\n\n"
    words += "Every limit holds.\n\n" if not failed else f"{len(failed)} of {len(lines)} limits do not hold.\n\n"
    counts = by_check["instructions"]
    worst = max(counts, key=lambda line: abs(line["difference"]))
    words += (f"- Instructions per step differ by {abs(worst['difference']):.3%} at most ({worst['feature']}, {worst['bodies']} bodies).\n"
              f"- Slopes per body differ by {max(abs(line['difference']) for line in by_check['slope']):.4%} at most.\n"
              f"- {sum(len(line['called']) for line in by_check['calls'])} of {sum(line['functions'] for line in by_check['calls'])} "
              "functions of features that the scene does not use are called.\n"
              f"- An empty world takes {by_check['empty_world'][0]['bytes']:,} bytes; a body with its shape and contacts "
              f"{by_check['bytes_per_body'][0]['bytes']:,.0f}.\n\n")
    words += "## Instructions per step of a scene that does not use the feature\n\n"
    sizes = sorted({line["bodies"] for line in counts})
    rows = []
    for feature in dict.fromkeys(line["feature"] for line in counts):
        own = {line["bodies"]: line for line in counts if line["feature"] == feature}
        slope = next(line for line in by_check["slope"] if line["feature"] == feature)
        rows.append([f"without {feature.replace('_', ' ')}", *(f"{own[n]['difference']:+.4%}" for n in sizes),
                     f"{slope['without']:,.1f}", f"{slope['difference']:+.4%}",
                     "the same" if all(line["same_state_and_allocations"] for line in own.values()) else "**another**"])
    words += paragraph("More instructions in the full build than in the one without, at each number of bodies; instructions per body, and how much more "
              "they are in the full build; whether states and allocations are the same.")
    words += table(["", *(f"{n:,} bodies" for n in sizes), "per body", "more", "states"], rows)
    words += "![Instructions per step](images/cost/instructions.svg)\n\n"
    words += "## What one more costs\n\n" + paragraph(
              f"Added to a scene of {by_check['added'][0]['bodies']:,} bodies; `report` is a call of `World::report` after each step, which "
              "the step must not feel. The first joint and the first fast body have parts that grow with the number of awake bodies: velocities "
              "are then kept apart for joints and contacts, and ways are looked at ahead.")
    full = next(line["full"] for line in counts if line["bodies"] == sizes[-1])
    words += table(["one", "instructions a step", "of the step", "at most"],
                   [[line["what"], f"{line['instructions']:,.0f}", f"{line['instructions'] / full:.2%}", f"{line['most']:,}"]
                    for line in by_check["added"]])
    words += "## What a build without the feature says\n\n"
    words += "".join(f"- {line['said']}\n" for line in by_check["refusal"]) + "\n"
    first = counts[0]["feature"]
    own = sorted((line for line in counts if line["feature"] == first), key=lambda line: line["bodies"])
    images = {"cost/instructions.svg": charts.curves(
        "Instructions per step", "bodies", "instructions",
        [("everything", [(line["bodies"], line["full"]) for line in own]),
         (f"without {first.replace('_', ' ')}", [(line["bodies"], line["without"]) for line in own])])}
    return words, images


# ---- docs/performance.md


def step_ms(line):
    """The mean of the fastest run; its first step, which finds every pair at once, is not timed."""
    return line["ms_total"] / (line["steps"] - 1)


def performance(results):
    lines = results.lines("compare")
    engines = engines_of(lines)
    scenes = {}
    for line in lines:
        scenes.setdefault(line["scene"], {})[line["engine"]] = line
    peers = [engine for engine in engines if engine != CAIRN]
    words = results.head(
        "Performance",
        "The time of a step, on fixed scenes, of Cairn and of other engines in turns; the fastest run of each counts. What the "
        "scenes are is told in [tools/bench](../tools/bench/README.md).", "compare", "scale")
    words += "## In short\n\n"
    for peer in peers:
        own = {name: row[peer]["ratio"] for name, row in scenes.items() if peer in row}
        faster = [name for name, ratio in own.items() if ratio < 1]
        middle = sorted(own.values())[len(own) // 2]
        words += (f"- {peer} takes {min(own.values()):.2f} to {max(own.values()):.1f} times as long as Cairn, {middle:.1f} times in the "
                  f"median of {len(own)} scenes" + (f"; it is faster in {listed(faster)}" if faster else "") + ".\n")
    words += "\n" + paragraph("Time alone says little: an engine that lets bodies sink, or puts them to sleep early, has less to do. The columns beside "
              "tell how much work there was and how well it was done: the pairs that touch, the deepest overlap, and the root mean square "
              "by which velocities change in one more step.")
    rows = []
    for name, row in scenes.items():
        for engine in engines:
            line = row.get(engine)
            if line is None:
                continue
            rows.append([name if engine == CAIRN else "", engine, shown(step_ms(line), "{:.3f}"),
                         shown(line["ratio"], "{:.2f}"), f"{line['bodies']:,}", f"{line['touching']:,}",
                         f"{1000 * line['max_penetration_m']:.2f}", f"{line['jitter_m_s']:.1e}"])
    words += "![Time of a step](images/performance/scenes.svg)\n\n"
    words += table(["scene", "engine", "ms a step", "ratio", "bodies", "touching", "deepest mm", "jitter m/s"], rows)
    images = {"performance/scenes.svg": charts.bars(
        "Time of a step", "ms", [(name, [step_ms(row[e]) if e in row else None for e in engines])
                                 for name, row in scenes.items()], engines)}
    scale = results.lines("scale")
    if scale:
        series = {}
        for line in scale:
            series.setdefault(line["threads"], []).append((line["bodies"], line["ms_per_step"]["min"]))
        images["performance/scale.svg"] = charts.curves(
            "Stacks of boxes, all awake", "bodies", "ms a step, fastest",
            [(f"{threads} thread" + ("s" if threads > 1 else ""), sorted(points)) for threads, points in sorted(series.items())])
        words += "## How the time grows\n\n![Time over bodies](images/performance/scale.svg)\n\n"
        words += table(["bodies", *(f"{t} thread{'s' if t > 1 else ''}, ms" for t in sorted(series)), "stages of one thread, most first"],
                       [[f"{line['bodies']:,}", *(f"{dict(series[t])[line['bodies']]:.2f}" for t in sorted(series)),
                         ", ".join(f"{name} {ms:.2f}" for name, ms in sorted(line["stages_ms"].items(), key=lambda s: -s[1])[:4])]
                        for line in sorted(scale, key=lambda one: one["bodies"]) if line["threads"] == 1])
    return words, images


# Document -> what makes it, and the results that it needs.
DOCUMENTS = {
    "accuracy": (accuracy, ["accuracy"]),
    "stability": (stability, ["torture"]),
    "cost": (cost, ["cost"]),
    "performance": (performance, ["compare"]),
}


def write(results, to, only):
    """Writes the documents whose results are there; those named in `only`, unless it is empty."""
    written = []
    for name, (make, needs) in DOCUMENTS.items():
        if (only and name not in only) or not results.has(*needs):
            continue
        words, images = make(results)
        (to / f"{name}.md").write_text(words.rstrip() + "\n")
        for path, svg in images.items():
            (to / "images" / path).parent.mkdir(parents=True, exist_ok=True)
            (to / "images" / path).write_text(svg)
        written.append(name)
    return written
