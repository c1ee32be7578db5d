"""What may be said: the words in which machines, effects and measurements are declared."""
