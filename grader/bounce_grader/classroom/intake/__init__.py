"""Finds the students' submissions in a download from Canvas, Moodle or Blackboard, by Canvas's API,
or in a folder; and reads the files that an instructor writes by hand.

May import: common, submission.
"""
