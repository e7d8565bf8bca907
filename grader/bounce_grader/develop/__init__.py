"""Tools for developing the kit: tests, benchmarks, fuzzing, doctor, the study.

Imports: build, classroom.intake, common, grading, publish, sandbox, submission.
"""
