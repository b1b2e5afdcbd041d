"""Scenes, runs and references that error_time.py, honesty.py and slopes.py share."""
