"""The grade book, the feedback pages and the page about the class.

Imports: classroom.intake, classroom.work, common, formats, grading.
"""
