"""Runs decks, compares what they give with answers known beforehand, writes the report."""
