"""What other codes reach: figures typed in, each with its source."""

HERE_SOURCE = ("measured for this project with the code's own release: 2 cores at 2.5 GHz with AVX-512, "
               "g++ 12 -O3 -march=native, double")

# code and case, elements, neighbours, million element-steps/s on one core, on two
MEASURED = [
    ("LAMMPS MACHDYN, updated Lagrangian SPH, Johnson-Cook Taylor bar", 74_766, "26.5", "0.402", "0.653"),
    ("the same, 144 399 particles", 144_399, "27", "0.373", "0.660"),
    ("the same, wider kernel", 74_766, "91", "0.136", "0.244"),
    ("LAMMPS MACHDYN, total Lagrangian SPH", 74_766, "30", "0.258", "0.472"),
    ("the same, wider kernel", 74_766, "about 100", "0.081", "0.150"),
    ("LULESH 2.0, size 45: one-point hexes, hourglass control, viscosity, equation of state", 91_125, "-", "1.00",
     "1.5 to 1.9"),
]

# As their authors publish them; other machines.
PUBLISHED = [
    ("ETH 2D cutting code on a P100 GPU, 150 000 particles, 1 mm of cut at 70 m/min",
     "71 M particle-steps/s in double (adiabatic), 48 M with conduction, 96 M in float"),
    ("the same code's CPU version with refinement, one core", "0.26 to 0.30 M particle-steps/s"),
    ("Abaqus CEL, orthogonal cutting, 216 000 to 273 000 nodes, mass factor 1e3, 4 cores", "10 to 50 hours a run"),
]
