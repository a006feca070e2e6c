#!/usr/bin/python3
"""Best place of the shaft as one would find it with SciPy (Debian: python3-scipy): Nelder and Mead over x and y
on the range at every degree. For comparison with bench-core-balance-shaft --benchmark_filter=best_place.

    position_scipy.py [CASE] [BENCH-CORE-BALANCE-SHAFT]
"""
import json
import pathlib
import subprocess
import sys
import time

import numpy as np
from scipy.optimize import minimize

root = pathlib.Path(__file__).resolve().parents[3]
case = sys.argv[1] if len(sys.argv) > 1 else root / "resources/examples/tmz-650d.case.json"
data = json.load(open(case))["input"]
mass = data.get("reciprocating_mass_kg") or sum(data["reciprocating_masses_kg"].values())
omega = data.get("angular_speed_rad_s") or data["speed_rpm"] * np.pi / 30
force = mass * data["crank_radius_mm"] / 2000 * omega**2  # P1, equation (1), N

phi = np.radians(np.arange(721))
moment = -np.interp(np.degrees(phi), data["torque"]["crank_angle_deg"], data["torque"]["torque_Nm"])
cos, sin = force * np.cos(phi), force * np.sin(phi)


def range_at(place):
    total = moment + place[0] * cos + place[1] * sin
    return total.max() - total.min()


times = []
for _ in range(30):
    start = time.perf_counter()
    found = minimize(range_at, [0.0, 0.0], method="Nelder-Mead",
                     options={"xatol": 1e-12, "fatol": 1e-9, "initial_simplex": [[0, 0], [0.05, 0], [0, 0.05]]})
    times.append(time.perf_counter() - start)
print(f"SciPy Nelder-Mead: {1e6 * min(times):.0f} us, median {1e6 * sorted(times)[15]:.0f} us, "
      f"{found.nfev} evaluations, l {1e3 * np.hypot(*found.x):.4f} mm, range {found.fun:.6f} N m")
if len(sys.argv) > 2:
    subprocess.run([sys.argv[2], "--benchmark_filter=best_place/49|nelder", "--benchmark_min_time=0.3"], check=True)
