"""Many runs of a deck as one thing: plan.py says which, runs.py runs them, slurm.py has a cluster run them, table.py puts
them together, effects.py and pictures.py say what follows."""
