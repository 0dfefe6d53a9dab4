"""Time limits, progress, and Ctrl-C: the run ends soon, and leaves a valid result or none."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import meshes
import surface_mesh_cutting as smc

LARGE = meshes.sphere(6)  # 32,768 triangles
SLACK = float(os.environ.get("UNWRAP_TEST_SLACK", "3"))  # seconds, from the stop to the end
FOLDER = os.path.dirname(os.path.abspath(__file__))


def long_run(**options):
    return smc.unwrap(*LARGE, effort="best", **options)


def test_time_limit():
    """There is a result in any case; no feature points before they are found."""
    for seconds in (1e-9, 3.0):
        start = time.monotonic()
        result = long_run(time_limit=seconds)
        assert result.status == "stopped" and result.stopped
        assert smc.certify_unwrap(*LARGE, result.corner_uv)
        assert time.monotonic() - start < seconds + SLACK
    with pytest.raises(smc.StoppedError) as caught:
        smc.detect_feature_points(*LARGE, time_limit=1e-9)
    assert caught.value.status == "stopped"


def test_progress():
    thread, calls = threading.get_ident(), []
    smc.unwrap(*LARGE, progress=lambda phase, fraction: calls.append((phase, fraction, threading.get_ident())))
    assert calls and {call[2] for call in calls} == {thread}
    assert {call[0] for call in calls} <= {"candidates", "filter", "connect", "refine", "parameterize", "pack"}
    fractions = [fraction for _, fraction, _ in calls]
    assert fractions == sorted(fractions) and fractions[0] >= 0 and fractions[-1] == 1


def test_progress_that_raises():
    def fail(phase, fraction):
        raise LookupError(phase)

    start = time.monotonic()
    with pytest.raises(LookupError):
        long_run(progress=fail)
    assert time.monotonic() - start < SLACK


def test_progress_that_ends_the_run():
    start = time.monotonic()
    assert long_run(progress=lambda phase, fraction: False).stopped
    assert time.monotonic() - start < SLACK


def test_progress_that_returns_a_number_of_numpy():
    assert long_run(progress=lambda phase, fraction: np.float64(fraction) < 0).stopped


def test_lock_is_released():
    counted, is_done = [0], threading.Event()

    def count():
        while not is_done.wait(0.001):
            counted[0] += 1

    counter = threading.Thread(target=count)
    counter.start()
    start = time.monotonic()
    smc.greedy_cut(*LARGE, effort="fast", threads=1)
    elapsed = time.monotonic() - start
    is_done.set()
    counter.join()
    assert counted[0] > 20 * elapsed


PROLOGUE = f"""
import signal, sys, time
sys.path.insert(0, {FOLDER!r})
import meshes, surface_mesh_cutting as smc
mesh = meshes.sphere(6)
"""


def run_until_signal(code, seconds, times=1):
    """Runs Python, sends SIGINT when it has printed a line and `seconds` have passed, and returns its exit code and words."""
    process = subprocess.Popen([sys.executable, "-B", "-c", PROLOGUE + code], stdout=subprocess.PIPE, text=True,
                               stderr=subprocess.PIPE)
    assert process.stdout.readline().strip() == "ready"
    for _ in range(times):
        time.sleep(seconds)
        process.send_signal(signal.SIGINT)
    start = time.monotonic()
    output, errors = process.communicate(timeout=60)
    assert time.monotonic() - start < SLACK
    return process.returncode, output, errors


def test_interrupt_before_there_is_a_result():
    code, output, errors = run_until_signal("""
mesh = meshes.sphere(7)
print("ready", flush=True)
smc.detect_feature_points(*mesh, effort="best")
""", 0.3)
    assert code != 0 and "KeyboardInterrupt" in errors and output == ""


def test_interrupt_yields_the_best_so_far():
    code, output, errors = run_until_signal("""
seams = smc.greedy_cut(*mesh, effort="fast").cut_edges
phases = []
def tell(phase, fraction):
    if phase == "refine" and not phases:
        print("ready", flush=True)
        phases.append(phase)
result = smc.unwrap(*mesh, effort="best", initial_cut=seams, maximum_average_distortion=4.0001, progress=tell)
print(result.status, result.stopped, bool(smc.certify_unwrap(*mesh, result.corner_uv)))
""", 0.05)
    assert code == 0, errors
    assert output.split() == ["stopped", "True", "True"]


def test_second_interrupt_passes():
    code, output, errors = run_until_signal("""
phases = []
def tell(phase, fraction):
    if not phases:
        print("ready", flush=True)
        phases.append(phase)
    time.sleep(0.5)
try:
    smc.unwrap(*mesh, effort="best", progress=tell)
    print("result")
except KeyboardInterrupt:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the second one, if the first one was enough
    print("interrupted")
""", 0.2, times=2)
    assert code == 0 and output.split() == ["interrupted"], errors


def test_handlers_of_the_caller():
    """A handler that raises something else ends the run, and its exception passes."""
    code, output, errors = run_until_signal("""
def fail(*_):
    raise LookupError("mine")
signal.signal(signal.SIGINT, fail)
print("ready", flush=True)
try:
    smc.unwrap(*mesh, effort="best")
except LookupError as error:
    print(error)
""", 0.3)
    assert code == 0 and output.split() == ["mine"], errors


def test_end_of_the_interpreter():
    """It ends the calls of daemon threads, and its exit status is that of the script."""
    for code in ("sys.exit(3)", "raise LookupError", ""):
        process = subprocess.run([sys.executable, "-B", "-c", PROLOGUE + f"""
import threading
def run_for_ever():
    while True:
        smc.unwrap(*mesh, effort="best", progress=lambda phase, fraction: started.set())
started = threading.Event()
for _ in range(2):
    threading.Thread(target=run_for_ever, daemon=True).start()
started.wait()
{code}
"""], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60, check=False)
        assert process.returncode == {"sys.exit(3)": 3, "": 0}.get(code, 1), process.stderr
        assert "terminate" not in process.stderr


def test_other_functions_stop():
    points, faces = LARGE
    with pytest.raises(smc.StoppedError):
        smc.cut_handles(*meshes.torus_of_quads(300, 100), time_limit=1e-9)
    edges = meshes.edges(faces)
    weights = np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
    terminals = np.arange(0, len(points), 150)
    tree = smc.steiner_tree(edges, weights, terminals, time_limit=0.2)
    assert tree.stopped and tree.status == "stopped"
    start = time.monotonic()
    try:
        assert smc.connect_points(points, faces, terminals, time_limit=0.2).stopped
    except smc.StoppedError:
        pass
    assert time.monotonic() - start < SLACK
