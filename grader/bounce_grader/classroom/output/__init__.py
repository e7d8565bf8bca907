"""The grade book, the feedback pages and the page about the class.

May import: assignment, classroom.intake, classroom.work, common, formats, grading.
"""
