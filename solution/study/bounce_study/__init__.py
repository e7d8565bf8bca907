"""Runs the study of ./kit study, and makes its tables, charts and pages."""
