//! The pipeline: families in, the text of every generated file out, each kernel proved equal to its references.

use crate::algebra::Algebra;
use crate::kernel::{KernelError, ProofError, WrittenError, golden_example, make, make_as_written, prove};
use crate::program::cost;
use crate::rust::{ExampleText, KernelText, ModuleText, print_module};
use closedform_bounds::with_certificates;
use closedform_bounds::{BoundError, certified_bound_proof};
use closedform_maxima::Definition;
use closedform_project::contract::KernelContract;
use closedform_project::family::{Family, Paths};
use closedform_project::generated::{Generated, Made, Refused};
use closedform_project::golden::{self, GoldenError, GoldenValue};
use closedform_project::sample::{EmptyDomain, sample};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use thiserror::Error;

/// Why a family was not generated.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PipelineError {
    /// A kernel could not be made.
    #[error("{place}: kernel `{kernel}`: {cause}")]
    Kernel {
        /// `family::name`
        kernel: String,
        /// Where its formula stands.
        place: String,
        /// Why.
        cause: KernelError,
    },
    /// A domain without points.
    #[error(
        "{place}: kernel `{kernel}` has an empty domain: {cause}\ncorrect the conditions, or the `typical` magnitudes of its inputs"
    )]
    Empty {
        /// `family::name`
        kernel: String,
        /// Where its formula stands.
        place: String,
        /// Why.
        cause: EmptyDomain,
    },
    /// A generated file does not read back.
    #[error("the generated text of `{family}` does not read back: {cause}")]
    Unreadable {
        /// The family.
        family: String,
        /// Why.
        cause: syn::Error,
    },
    /// A kernel is not there.
    #[error("kernel `{0}` is not in the generated text")]
    Missing(String),
    /// The golden values cannot be read.
    #[error(transparent)]
    Golden(#[from] GoldenError),
    /// A kernel is not proved.
    #[error("{place}: kernel `{kernel}`: {cause}")]
    Unproved {
        /// `family::name`
        kernel: String,
        /// Where its formula stands.
        place: String,
        /// Why.
        cause: ProofError,
    },
    /// A bound is not what the Rust text proves.
    #[error(
        "{place}: kernel `{kernel}`: its bound is not re-derived from the Rust text:\n{cause}\nin a generated kernel: say more of \
         the signs in a contract's domain, or split the formula"
    )]
    Bound {
        /// `family::name`
        kernel: String,
        /// Where its formula stands.
        place: String,
        /// Why.
        cause: BoundError,
    },
}

impl PipelineError {
    /// The kernel whose proof takes more work than one formula may, if that is the cause.
    #[must_use]
    pub fn kernel_beyond_limit(&self) -> Option<&str> {
        match self {
            Self::Unproved { kernel, cause, .. } if cause.is_beyond_limit() => Some(kernel),
            _ => None,
        }
    }

    /// The kernel that it is about: `family::name`.
    fn kernel(&self) -> Option<&str> {
        match self {
            Self::Kernel { kernel, .. }
            | Self::Empty { kernel, .. }
            | Self::Missing(kernel)
            | Self::Unproved { kernel, .. }
            | Self::Bound { kernel, .. } => Some(kernel),
            Self::Unreadable { .. } | Self::Golden(_) => None,
        }
    }

    /// The kernel whose text or bound is not proved, and what of it, if that is the cause.
    fn unproved_kernel(&self) -> Option<(&str, String)> {
        match self {
            Self::Unproved { kernel, .. } => {
                Some((kernel, "its stable form is not proved to be equal to the formula".to_owned()))
            }
            Self::Bound { kernel, cause, .. } => {
                let cause = cause.to_string();
                let first = cause.lines().next().unwrap_or_default();
                Some((kernel, format!("the bound of its stable form is not proved: {first}")))
            }
            _ => None,
        }
    }
}

/// What is wrong with several kernels, as one text.
pub fn all(causes: &[PipelineError]) -> String {
    causes.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

/// How many kernels these say something against.
pub fn kernels_refused(causes: &[PipelineError]) -> usize {
    causes.iter().filter_map(PipelineError::kernel).collect::<BTreeSet<_>>().len()
}

/// Generates all families; `progress` is told the name and the place of every kernel before it is made, and before it is
/// proved.
///
/// # Errors
/// Every kernel that cannot be made or is not proved.
pub fn generate(
    algebra: Algebra,
    families: &[Family],
    mut progress: impl FnMut(&str, &str),
) -> Result<Generated, Vec<PipelineError>> {
    let (generated, causes) = each(families, |family| attempt(algebra, family, &mut progress));
    if causes.is_empty() { Ok(generated) } else { Err(causes) }
}

/// As [`generate`], but what cannot be made or is not proved is left out, and told in [`Generated::refused`].
///
/// # Errors
/// When no kernel is left.
pub fn generate_what_can_be(
    algebra: Algebra,
    families: &[Family],
    mut progress: impl FnMut(&str, &str),
) -> Result<Generated, Vec<PipelineError>> {
    let (mut generated, causes) = each(families, |family| {
        let made = attempt(algebra, family, &mut progress);
        what_is_proved(algebra, family, made, &mut progress)
    });
    if generated.kernels.is_empty() {
        return Err(causes);
    }
    generated.refused = causes.iter().map(refusal).collect();
    Ok(generated)
}

/// What attempts make of families, one after another, and all that they refuse. A family of which nothing is left has no
/// file.
fn each(families: &[Family], mut attempt: impl FnMut(&Family) -> Attempt) -> (Generated, Vec<PipelineError>) {
    let (mut generated, mut causes) = (Generated::default(), Vec::new());
    for family in families {
        let Attempt { kernels, text, refused } = attempt(family);
        if !kernels.is_empty() || refused.is_empty() {
            generated.kernels.extend(kernels.iter().map(|kernel| made(family, kernel)));
            generated.files.insert(format!("{}.rs", family.name), text);
        }
        causes.extend(refused);
    }
    (generated, causes)
}

/// The same without the kernels that are refused, proved once more where others are left.
fn what_is_proved(
    algebra: Algebra,
    family: &Family,
    mut made: Attempt,
    progress: &mut impl FnMut(&str, &str),
) -> Attempt {
    let mut left = family.clone();
    let mut causes = Vec::new();
    while !made.refused.is_empty() && !made.kernels.is_empty() {
        left = left.without(&refused_names(family, &made.refused));
        made.kernels.retain(|kernel| left.contract.kernels.iter().any(|fine| fine.name == kernel.name));
        causes.append(&mut made.refused);
        made.text = module_text(&left, &made.kernels);
        made.refused = unproved(algebra, &left, &made.text, &mut *progress);
    }
    causes.append(&mut made.refused);
    Attempt { refused: causes, ..made }
}

/// The kernels that these causes are about; all of the family where one names none.
fn refused_names(family: &Family, causes: &[PipelineError]) -> BTreeSet<String> {
    let start = format!("{}::", family.name);
    let name = |cause: &PipelineError| Some(cause.kernel()?.strip_prefix(&start)?.to_owned());
    let named: Option<BTreeSet<String>> = causes.iter().map(name).collect();
    named.unwrap_or_else(|| family.contract.kernels.iter().map(|kernel| kernel.name.clone()).collect())
}

fn refusal(cause: &PipelineError) -> Refused {
    Refused { kernel: cause.kernel().unwrap_or_default().to_owned(), because: cause.to_string() }
}

/// The kernels of a family as far as they can be made, their text, and what is wrong with them and the others.
struct Attempt {
    kernels: Vec<KernelText>,
    text: String,
    refused: Vec<PipelineError>,
}

fn attempt(algebra: Algebra, family: &Family, progress: &mut impl FnMut(&str, &str)) -> Attempt {
    let (mut kernels, mut unmade) = make_kernels(algebra, family, progress);
    let mut text = module_text(family, &kernels);
    let mut open = unproved(algebra, family, &text, &mut *progress);
    if take_as_written(family, &open, &mut kernels, &mut unmade) {
        text = module_text(family, &kernels);
        open = unproved(algebra, family, &text, &mut *progress);
    }
    // a kernel that is not made is missing, but for another reason
    let missing = |cause: &PipelineError| !unmade.is_empty() && matches!(cause, PipelineError::Missing(_));
    let mut refused: Vec<PipelineError> = open.into_iter().filter(|cause| !missing(cause)).collect();
    refused.extend(unmade);
    Attempt { kernels, text, refused }
}

/// The kernels of a family that can be made, and why the others cannot.
fn make_kernels(
    algebra: Algebra,
    family: &Family,
    progress: &mut impl FnMut(&str, &str),
) -> (Vec<KernelText>, Vec<PipelineError>) {
    let (mut kernels, mut causes) = (Vec::new(), Vec::new());
    let golden = golden(family).unwrap_or_else(|cause| {
        causes.push(cause.into());
        Vec::new()
    });
    for kernel in &family.contract.kernels {
        let name = format!("{}::{}", family.name, kernel.name);
        progress(&name, family.place(&kernel.name));
        match make_kernel(algebra, family, kernel, &golden, name) {
            Ok(made) => kernels.push(made),
            Err(cause) => causes.push(cause),
        }
    }
    (kernels, causes)
}

/// The golden values of a family that Maxima has derived.
fn golden(family: &Family) -> Result<Vec<GoldenValue>, GoldenError> {
    let Paths { contract, reference, golden, .. } = &family.paths;
    let derived = [contract, reference, golden].into_iter().all(|path| path.exists());
    if derived { golden::load(golden) } else { Ok(Vec::new()) }
}

/// Takes the formulas of kernels that are not proved as they are written; whether there are any.
fn take_as_written(
    family: &Family,
    unproved: &[PipelineError],
    kernels: &mut [KernelText],
    unmade: &mut Vec<PipelineError>,
) -> bool {
    let name = |kernel: &KernelText| format!("{}::{}", family.name, kernel.name);
    let open: BTreeMap<&str, String> = unproved.iter().filter_map(PipelineError::unproved_kernel).collect();
    for kernel in kernels {
        let contract = family.contract.kernels.iter().find(|contract| contract.name == kernel.name);
        let (Some(because), Some(contract)) = (open.get(name(kernel).as_str()), contract) else { continue };
        match as_written(family, &family.completed(contract), because.clone()) {
            Ok(made) => *kernel = KernelText { example: kernel.example.take(), ..made },
            Err(cause) => {
                let place = family.place(&kernel.name).to_owned();
                unmade.push(PipelineError::Kernel { kernel: name(kernel), place, cause });
            }
        }
    }
    !open.is_empty()
}

fn as_written(family: &Family, kernel: &KernelContract, because: String) -> Result<KernelText, KernelError> {
    let made = make_as_written(&family.contract, kernel, &references_of(family, kernel), because)?;
    match beyond_the_language(family, &made) {
        None => Ok(made),
        Some(because) => {
            let cause = WrittenError::BeyondTheLanguage(because);
            Err(KernelError::Written { function: kernel.name.clone(), cause })
        }
    }
}

/// Why the text of a kernel does not read back, if it does not: the kernel language has limits, for compensated
/// expressions above all.
fn beyond_the_language(family: &Family, kernel: &KernelText) -> Option<String> {
    let cause = closedform_syntax::parse_file(&module_text(family, std::slice::from_ref(kernel))).err()?;
    Some(cause.to_string())
}

fn make_kernel(
    algebra: Algebra,
    family: &Family,
    kernel: &KernelContract,
    golden: &[GoldenValue],
    name: String,
) -> Result<KernelText, PipelineError> {
    let kernel = &family.completed(kernel);
    let inputs = family.contract.inputs_of(kernel);
    let place = || family.place(&kernel.name).to_owned();
    let points = sample(&kernel.domain, &inputs, 1, 0).map_err(|cause| PipelineError::Empty {
        kernel: name.clone(),
        place: place(),
        cause,
    })?;
    let call = || Some(ExampleText { inputs: points.into_iter().next()?, results: Vec::new() });
    let example = golden_example(kernel, golden).or_else(call);
    let references = references_of(family, kernel);
    let made = match make(algebra, &family.contract, kernel, &references) {
        Err(cause) if cause.leaves_the_formula_as_written() => as_written(family, kernel, cause.to_string()),
        Err(cause) => Err(cause),
        Ok(made) => match beyond_the_language(family, &made) {
            Some(cause) => {
                as_written(family, kernel, format!("its stable form is beyond the kernel language: {cause}"))
            }
            None => Ok(made),
        },
    };
    let made = made.map_err(|cause| PipelineError::Kernel { kernel: name, place: place(), cause })?;
    Ok(KernelText { example, ..made })
}

fn module_text(family: &Family, kernels: &[KernelText]) -> String {
    let text = print_module(&ModuleText {
        family: &family.name,
        title: &family.contract.family.title,
        source: &family.contract.family.source,
        made_from: &made_from(family),
        kernels,
    });
    // what certificates are worth is shown next: every stated bound is proved before the text leaves
    with_certificates(&text)
}

/// The reference expressions of a kernel, one a result.
fn references_of(family: &Family, kernel: &KernelContract) -> Vec<Definition> {
    let results = family.results().filter(|(owner, ..)| owner.name == kernel.name);
    results.map(|(_, _, reference)| reference.clone()).collect()
}

fn made_from(family: &Family) -> String {
    let file = |path: &Path| path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let Paths { worksheet, contract, reference, .. } = &family.paths;
    match (contract.exists(), reference.exists()) {
        (false, _) => file(worksheet),
        (true, false) => format!("{} and {}", file(worksheet), file(contract)),
        (true, true) => format!("{} and {}", file(reference), file(contract)),
    }
}

/// The kernels of a family's generated text that are not proved equal to its reference expressions, or whose bounds are
/// not what their text proves; or why the text does not read back. `progress` is told as by [`generate`].
pub fn unproved(
    algebra: Algebra,
    family: &Family,
    text: &str,
    mut progress: impl FnMut(&str, &str),
) -> Vec<PipelineError> {
    let sources = match closedform_syntax::parse_file(text) {
        Ok(sources) => sources,
        Err(cause) => return vec![PipelineError::Unreadable { family: family.name.clone(), cause }],
    };
    let mut causes = Vec::new();
    for kernel in &family.contract.kernels {
        let name = format!("{}::{}", family.name, kernel.name);
        match sources.iter().find(|source| source.name == kernel.name) {
            None => causes.push(PipelineError::Missing(name)),
            Some(source) => {
                progress(&name, family.place(&kernel.name));
                let proof = prove(algebra, source, &family.completed(kernel), &references_of(family, kernel));
                let bound = certified_bound_proof(source);
                let place = || family.place(&kernel.name).to_owned();
                let bound = bound.map_err(|cause| PipelineError::Bound { kernel: name.clone(), place: place(), cause });
                causes.extend(proof.err().map(|cause| PipelineError::Unproved { kernel: name, place: place(), cause }));
                causes.extend(bound.err());
            }
        }
    }
    causes
}

fn made(family: &Family, kernel: &KernelText) -> Made {
    let cost = cost(&kernel.graph, &kernel.program.outputs);
    Made {
        kernel: format!("{}::{}", family.name, kernel.name),
        rules: kernel.rules.iter().map(|rule| rule.name.to_owned()).collect(),
        operations: [cost.additions, cost.multiplications, cost.divisions, cost.roots, cost.double_double],
        bound: kernel.results.iter().map(|result| result.bound).fold(0.0, f64::max),
        certified_because: kernel.certified_because.clone(),
        added: if family.paths.contract.exists() { added(family, kernel) } else { Vec::new() },
    }
}

/// The conditions of a kernel that its contract does not state.
fn added(family: &Family, kernel: &KernelText) -> Vec<String> {
    let contract = family.contract.kernels.iter().find(|contract| contract.name == kernel.name);
    let stated = |text: &str| contract.is_some_and(|contract| contract.domain.texts().any(|known| known == text));
    kernel.requires.iter().map(|require| require.text.clone()).filter(|text| !stated(text)).collect()
}
