"""Families of equations y'' = r y with known differential Galois groups, for the benchmarks."""
