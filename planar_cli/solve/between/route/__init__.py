"""The cheapest way through the equations to what is asked."""
