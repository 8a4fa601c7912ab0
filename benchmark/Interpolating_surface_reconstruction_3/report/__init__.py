"""Runs the jobs of the benchmark and makes tables, plots, pictures and a page of their results."""
