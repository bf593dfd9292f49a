"""Homework: problem sets, grading, and the files of teaching platforms."""
