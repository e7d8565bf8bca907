"""The grade book, the feedback pages and the page about the class.

Imports: assignment, classroom.intake, classroom.work, common, formats, grading.
"""
