"""What a file means without saying it: grounds, points where bodies touch, open ends, signs."""
