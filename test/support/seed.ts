/** Property tests draw the same in every run: what fails, fails again, and a change is not refused for another's rare draw. */
import fc from 'fast-check';

fc.configureGlobal({ seed: 20_170_131 });
