"""./kit study: what bounce_study measures, as tables, charts and pages."""
