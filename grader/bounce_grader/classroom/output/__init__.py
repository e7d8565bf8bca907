"""The grade book, the feedback pages and the page about the class.

May import: classroom.intake, classroom.grading, common, formats, grading.
"""
