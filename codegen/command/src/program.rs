//! The other programs of closedform: beside this command, on the path, or in the checkout that this command was built in.

use closedform_system::output::note;
use miette::Diagnostic;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use thiserror::Error;

/// A program that this command hands work on to.
#[derive(Debug)]
pub struct Program {
    /// The program and its package.
    pub name: &'static str,
    /// Its source in a checkout.
    pub folder: &'static str,
    /// What building it takes, if that is worth a word.
    pub takes: &'static str,
}

/// After this time a build is worth a word: cargo takes less where there is nothing to do.
const SOON: Duration = Duration::from_secs(2);

/// Plans moves and draws them.
pub const MOTION: Program = Program { name: "closedform-motion", folder: "motion", takes: "" };

/// Makes kernels and proves them.
pub const GENERATOR: Program = Program {
    name: "closedform-symbolica",
    folder: "codegen/symbolica",
    takes: ": the first time that takes some minutes, most of them for Symbolica",
};

/// Why a program cannot be run.
#[derive(Debug, Error, Diagnostic)]
pub enum ProgramError {
    /// It is nowhere.
    #[error("the program `{}` is not installed", .0.name)]
    #[diagnostic(help(
        "run `cargo install --path {}` in a checkout of closedform, or put it beside `closedform` or on the PATH",
        .0.folder
    ))]
    Missing(&'static Program),
    /// It cannot be built.
    #[error("the program `{}` cannot be built ({status})", .program.name)]
    #[diagnostic(help("cargo said why above"))]
    Build {
        /// Which.
        program: &'static Program,
        /// How cargo ended.
        status: ExitStatus,
    },
    /// It does not start.
    #[error("cannot start `{}`: {cause}", .program.name)]
    #[diagnostic(help("end other programs if the machine has no more processes or memory"))]
    Start {
        /// Which.
        program: &'static Program,
        /// What the system says.
        cause: io::Error,
    },
    /// It is of another version.
    #[error("{} is {found}, but this command is of version {}", .path.display(), env!("CARGO_PKG_VERSION"))]
    #[diagnostic(help("install both from one checkout: `cargo install --path {}`", .program.folder))]
    Version {
        /// Which.
        program: &'static Program,
        /// Where it was found.
        path: PathBuf,
        /// What it says.
        found: String,
    },
}

impl Program {
    /// The program as it should be: in a checkout built from the source as it stands, elsewhere of this command's version.
    ///
    /// # Errors
    /// When it is nowhere, cannot be built, or is of another version.
    pub fn find(&'static self) -> Result<PathBuf, ProgramError> {
        self.build()?;
        let path = self.path().ok_or(ProgramError::Missing(self))?;
        let said = Command::new(&path).arg("--version").stdin(Stdio::null()).output();
        let said = said.map_err(|cause| ProgramError::Start { program: self, cause })?;
        let found = String::from_utf8_lossy(&said.stdout).trim().to_owned();
        if found.rsplit(' ').next() != Some(env!("CARGO_PKG_VERSION")) {
            return Err(ProgramError::Version { program: self, path, found });
        }
        Ok(path)
    }

    /// Where it is: beside this command, or on the path.
    fn path(&self) -> Option<PathBuf> {
        let path = std::env::var_os("PATH").unwrap_or_default();
        let folders = own_folder().into_iter().chain(std::env::split_paths(&path));
        folders.map(|folder| self.within(&folder)).find(|file| file.is_file())
    }

    /// Its file in a folder.
    fn within(&self, folder: &Path) -> PathBuf {
        folder.join(self.name).with_extension(std::env::consts::EXE_EXTENSION)
    }

    /// Who changes the source of a program in a checkout means the new one, though `cargo run` of this command does not build it.
    fn build(&'static self) -> Result<(), ProgramError> {
        let Some((mut cargo, built)) = self.cargo() else { return Ok(()) };
        let is_there = built.is_file();
        if is_there {
            cargo.arg("--quiet");
        } else {
            note(&format!("building {}{}", self.name, self.takes));
        }
        let built = cargo.spawn().and_then(|mut cargo| {
            if is_there && !ends_within(&mut cargo, SOON)? {
                note(&format!("building {} again, since what it is made of has changed", self.name));
            }
            cargo.wait()
        });
        match built {
            Ok(status) if !status.success() => Err(ProgramError::Build { program: self, status }),
            // without cargo what was built is taken
            _ => Ok(()),
        }
    }

    /// The call of cargo that builds it beside this command, and what comes of it; if this command stands where cargo has
    /// built it, and its source is there.
    fn cargo(&self) -> Option<(Command, PathBuf)> {
        let folder = own_folder().filter(|folder| folder.join(".fingerprint").is_dir())?;
        let manifest = checkout().join(self.folder).join("Cargo.toml");
        let profile = folder.file_name()?.to_str().map(|name| if name == "debug" { "dev" } else { name })?.to_owned();
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.args(["build", "--profile", &profile, "--target-dir"]).arg(folder.parent()?);
        cargo.arg("--manifest-path").arg(&manifest).args(["--package", self.name]);
        manifest.is_file().then(|| (cargo, self.within(&folder)))
    }
}

/// Whether a process ends within this time.
fn ends_within(process: &mut Child, time: Duration) -> io::Result<bool> {
    let end = Instant::now() + time;
    while Instant::now() < end {
        if process.try_wait()?.is_some() {
            return Ok(true);
        }
        sleep(Duration::from_millis(5));
    }
    Ok(false)
}

/// The checkout that this command was built in.
#[must_use]
pub fn checkout() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

fn own_folder() -> Option<PathBuf> {
    std::env::current_exe().ok()?.parent().map(Path::to_owned)
}
