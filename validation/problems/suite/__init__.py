"""Runs decks, compares the results with known answers and writes the report."""
