"""A whole class: from its submissions to a grade book, feedback and a page about the class.

May import: classroom.intake, classroom.output, classroom.grading, common.
"""
