"""The search for a law where no registered effect explains what is left: physics that no one wrote down yet."""
